/** The panel of the cue: aim, shoot, see what came of it, and go on. */

import { useEffect } from "preact/hooks";
import { drawing, run, time, vocabulary } from "../../studio/store";
import { language, number, word } from "../../words";
import { Amount } from "./Amount";
import { canTakeBack, gone, isOver, nextShot, shoot, takeBack } from "./game";
import { aimOn } from "./pointer";
import { aim, commit, forecast, isAiming, isOpen, prediction, stroke } from "./state";
import { storyOf } from "./story";
import { turned } from "./stroke";
import { TipPicture, tipWords } from "./TipPicture";
import "../../style/cue.css";

export function Cue() {
  useEffect(() => {
    isOpen.value = true;
    const canvas = document.querySelector<HTMLCanvasElement>("canvas.table");
    const end = canvas ? aimOn(canvas) : () => {};
    return () => {
      end();
      void commit();
      isOpen.value = false;
    };
  }, []);
  if (!stroke.value) return null;
  return (
    <div class="cue">
      <Actions />
      <Outcome />
      <Forecast />
      <Aim />
      <Gone />
    </div>
  );
}

function Actions() {
  const hasBegun = time.value > 0;
  return (
    <div class="actions">
      {hasBegun ? (
        <button type="button" class="primary" disabled={!run.value?.isWhole} onClick={nextShot}>
          {word("cueNext")}
        </button>
      ) : (
        <button type="button" class="primary" onClick={shoot}>
          {word("cueShoot")}
        </button>
      )}
      <button type="button" disabled={!canTakeBack.value} onClick={takeBack}>
        {word("cueTakeBack")}
      </button>
    </div>
  );
}

const idOf = (ball: number) => drawing.value?.balls[ball]?.id ?? "";

/** What came of the shot, once it has been played. */
function Outcome() {
  const shown = run.value;
  const cueBall = drawing.value?.cue?.shot?.ball;
  return (
    <div role="status">
      {isOver.value && shown && cueBall !== undefined && (
        <dl class="outcome">
          {outcome(storyOf(shown, cueBall, vocabulary.value?.kinds ?? [])).map(([term, said]) => (
            <div key={term}>
              <dt>{term}</dt>
              <dd>{said}</dd>
            </div>
          ))}
        </dl>
      )}
    </div>
  );
}

function outcome(story: ReturnType<typeof storyOf>): [string, string][] {
  const none = word("cueNone");
  const pocketed = story.pocketed.map(([ball, pocket]) => word("cueFallIn", { id: idOf(ball), pocket }));
  const rows: [string, string][] = [
    [word("cueFirstHit"), story.hits[0] === undefined ? none : idOf(story.hits[0])],
    [word("cueCushions"), word("cueCushionCounts", counts(story))],
    [word("cueAllCushions"), String(story.cushions)],
    [word("cuePocketed"), pocketed.join(", ") || none],
  ];
  if (story.offTable.length > 0) rows.push([word("cueOffTable"), story.offTable.map(idOf).join(", ")]);
  return rows;
}

const counts = ({ cushionsBefore, cushionsAfter }: ReturnType<typeof storyOf>) => ({
  before: cushionsBefore,
  after: cushionsAfter,
});

/** Where the stroke would lead, and what is against it. */
function Forecast() {
  return (
    <div class="forecast">
      {prediction.value?.problems.map(({ place, message }) => (
        <p class="refusal" role="alert" key={place + message}>
          <code>{place}</code>: {message}
        </p>
      ))}
      <p role="status" class="leads">
        {isAiming.value && leads()}
      </p>
      {isAiming.value && <Obstructed />}
    </div>
  );
}

function leads(): string {
  const found = forecast.value;
  if (!found) return "";
  const { contact, shown, shot, drawn, isMiscue } = found;
  if (isMiscue) return word("cueWillSlip");
  const story = storyOf(shown, shot.ball, vocabulary.value?.kinds ?? []);
  const at = (time: number) => `${number(time, 3)} ${drawn.units["time"] ?? ""}`.trim();
  const cushions = offCushions(story.cushionsBefore);
  if (contact) {
    return word("cueHits", { id: drawn.balls[contact.other]?.id ?? "", at: at(contact.time), cushions });
  }
  const [, pocket, fall = 0] = story.pocketed.find(([ball]) => ball === shot.ball) ?? [];
  return pocket ? word("cueHitsNoneFalls", { pocket, at: at(fall) }) : word("cueHitsNone");
}

function offCushions(count: number): string {
  if (count === 0) return "";
  return count === 1 ? word("cueAfterCushion") : word("cueAfterCushions", { count });
}

const list = (things: string[]) => new Intl.ListFormat(language.value).format(things);

/** What the stick would meet, and how far its butt has to be raised. */
function Obstructed() {
  const met = prediction.value?.obstructions ?? [];
  if (met.length === 0) return null;
  const things = met.map(({ kind, id }) => {
    return word(kind === "ball" ? "cueMeetsBall" : kind === "cushion" ? "cueMeetsCushion" : "cueMeetsCloth", {
      id: id ?? "",
    });
  });
  const angles = met.map(({ clear_from_deg }) => clear_from_deg ?? Number.POSITIVE_INFINITY);
  const clear = Math.ceil(Math.max(...angles) * 10) / 10;
  return (
    <p class="obstructed">
      {word("cueMeets", { things: list(things) })}{" "}
      {Number.isFinite(clear) ? (
        <button type="button" onClick={() => aim({ elevation: clear })}>
          {word("cueRaise", { angle: number(clear, 3) })}
        </button>
      ) : (
        word("cueNoRoom")
      )}
    </p>
  );
}

const rounded = (value: number) => Math.max(Math.round(value * 100) / 100, 0);

function Aim() {
  const [now, drawn] = [stroke.value, drawing.value];
  if (!now || !drawn) return null;
  const cue = forecast.value?.cue ?? drawn.cue;
  const radius = drawn.balls.find(({ id }) => id === now.ball)?.radius ?? 1;
  const { length = "", time: second = "" } = drawn.units;
  return (
    <div class="aim">
      <p class="hint">{word("cueHint")}</p>
      <Amount
        label={word("cueDirection")}
        value={now.direction}
        {...{ min: 0, max: 360, step: 0.5, fineStep: 0.01, unit: "°" }}
        rounded={turned}
        onValue={(direction) => aim({ direction })}
      />
      <Amount
        label={word("cueSpeed")}
        value={now.speed}
        {...{ min: 0, max: Math.ceil(4 * drawn.table.size), step: 0.1, fineStep: 0.01, rounded }}
        unit={length && second ? `${length}/${second}` : ""}
        onValue={(speed) => aim({ speed })}
      />
      <Amount
        label={word("cueElevation")}
        value={now.elevation}
        {...{ min: 0, max: 90, step: 1, fineStep: 0.1, unit: "°", rounded }}
        onValue={(elevation) => aim({ elevation: Math.min(elevation, 90) })}
      />
      {cue && (
        <div class="tip-row">
          <TipPicture stroke={now} cue={cue} radius={radius} isOff={forecast.value?.isMiscue ?? false} />
          <div>
            <p class="name">{word("cueTip")}</p>
            <p>{tipWords(now)}</p>
            <p class="hint">{word(cue.miscue_offset < 1 ? "cueTipHint" : "cueTipHintSafe")}</p>
            <button
              type="button"
              disabled={now.left === 0 && now.top === 0}
              onClick={() => aim({ left: 0, top: 0 })}
            >
              {word("cueToMiddle")}
            </button>
          </div>
        </div>
      )}
      <label class="cue-ball">
        <span>{word("cueBallStruck")}</span>
        <select value={now.ball} onChange={(event) => aim({ ball: event.currentTarget.value })}>
          {drawn.balls.map(({ id }) => (
            <option key={id} value={id}>
              {id}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}

/** The balls that are out of play. */
function Gone() {
  if (gone.value.length === 0) return null;
  return (
    <section class="gone" aria-label={word("cueGone")}>
      <h2>{word("cueGone")}</h2>
      <ul>
        {gone.value.map(([id, colour]) => (
          <li key={id}>
            <svg viewBox="0 0 10 10" width="14" height="14" aria-hidden="true">
              <circle cx="5" cy="5" r="4.5" fill={colour} stroke="currentColor" stroke-width="0.5" />
            </svg>
            {id}
          </li>
        ))}
      </ul>
    </section>
  );
}
