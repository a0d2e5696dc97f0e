/** Words beside what is dragged: why it cannot lie there, and that the page went to the start for it. And what a screen reader tells of the chosen ball. */

import { chosen, drawing } from "../studio/store";
import "../style/setup.css";
import { number, word } from "../words";
import { drag, reasonOf, shownView } from "./drag";

export function DragReason() {
  const [dragged, view] = [drag.value, shownView.value];
  return (
    <>
      {dragged && view && dragged.problems.length > 0 && (
        <p
          class="reason"
          lang="en"
          style={{ "--x": `${view.x(dragged.place[0])}px`, "--y": `${view.y(dragged.place[1])}px` }}
        >
          {reasonOf(dragged.problems)}
        </p>
      )}
      {dragged?.isFromLater && <p class="aside">{word("wentToStart")}</p>}
      <p class="help" id="table-help">
        {word("tableHelp")}
      </p>
      <p class="unseen" role="status">
        {chosenBall()}
      </p>
    </>
  );
}

function chosenBall(): string {
  const ball = drawing.value?.balls[chosen.value ?? -1];
  if (!ball) return "";
  const [x = 0, y = 0] = drag.value?.place ?? ball.position;
  return word("chosenBall", { id: ball.id, x: number(x), y: number(y) });
}
