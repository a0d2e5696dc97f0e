/** The offer to write out balls that come from a rack or a gas. */

import { change, chosen, drawing, engine, replace, scenario, settled, written } from "../../studio/store";
import { word } from "../../words";

/** Balls that are not written one by one. */
const isMade = () => "gas" in written.value || "rack" in written.value;

export function PlainBalls() {
  if (!isMade()) return null;
  const isGas = "gas" in written.value;
  return (
    <div class="offer">
      <p>{word(isGas ? "ballsFromGas" : "ballsFromRack")}</p>
      <button type="button" onClick={writeOut}>
        {word("plainBalls")}
      </button>
    </div>
  );
}

/** Writes all balls out; the table of a preset stays one. */
async function writeOut() {
  const json = scenario.peek()?.json ?? "{}";
  const id = drawing.peek()?.balls[chosen.peek() ?? -1]?.id;
  await settled(async () => {
    const { json: expanded } = await engine.ask("expanded", { json });
    if ("gas" in written.peek()) await replace(expanded);
    else await change({ balls: JSON.parse(expanded).balls, rack: null });
  });
  const at = drawing.peek()?.balls.findIndex((ball) => ball.id === id) ?? -1;
  chosen.value = at < 0 ? null : at;
}
