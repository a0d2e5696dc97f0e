/** One's own trajectory beside the run: what each line is, and how far it is from the run. */

import { useEffect, useRef } from "preact/hooks";
import type { Misreading } from "../../own/csv";
import { differences, forgetTrajectory, lateRows, misread, own } from "../../own/own";
import { Close } from "../../studio/App";
import { drawing, pause, seek } from "../../studio/store";
import { ballColours } from "../../table/colours";
import { number, word } from "../../words";

export function Own() {
  return (
    <section>
      <h2>{word("ownTitle")}</h2>
      {misread.value && <Misread />}
      {own.value ? <Legend /> : <p class="hint">{word("ownHint")}</p>}
    </section>
  );
}

function Legend() {
  const trajectory = own.value;
  const balls = drawing.value?.balls ?? [];
  const colours = ballColours(balls);
  if (!trajectory) return null;
  return (
    <>
      <p class="own-name">
        <strong>{trajectory.name}</strong> {word("ownRows", { rows: number(trajectory.times.length, 6) })}
      </p>
      <table class="own">
        <thead>
          <tr>
            <th scope="col">{word("ownBall")}</th>
            <th scope="col">{word("ownLargest")}</th>
            <th scope="col">{word("ownAt")}</th>
          </tr>
        </thead>
        <tbody>
          {differences.value.map(({ ball, largest, at }) => (
            <tr key={ball}>
              <th scope="row">
                <Swatch colour={colours[ball] ?? ""} /> {balls[ball]?.id}
              </th>
              <td>{largest === null ? "–" : number(largest)}</td>
              <td>{largest !== null && <GoTo time={at} />}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <Notes />
      <button type="button" onClick={forgetTrajectory}>
        {word("ownForget")}
      </button>
    </>
  );
}

function GoTo({ time }: { time: number }) {
  return (
    <button
      type="button"
      class="plain"
      title={word("ownGoTo", { time: number(time) })}
      onClick={() => {
        pause();
        seek(time);
      }}
    >
      {number(time)}
    </button>
  );
}

/** The line as it is drawn on the table. */
function Swatch({ colour }: { colour: string }) {
  return (
    <svg class="swatch" viewBox="0 0 28 10" width="28" height="10" aria-hidden="true">
      <path d="M1 5h26" />
      <circle cx="14" cy="5" r="3" fill={colour} />
    </svg>
  );
}

function Notes() {
  const trajectory = own.value;
  const notes = [
    trajectory?.isNearest && word("ownNearest"),
    lateRows.value > 0 && word("ownLate", { count: number(lateRows.value, 6) }),
    trajectory &&
      trajectory.leftOut.length > 0 &&
      word("ownLeftOut", { columns: trajectory.leftOut.join(", ") }),
  ].filter((note) => typeof note === "string");
  return (
    <ul class="hint">
      {notes.map((note) => (
        <li key={note}>{note}</li>
      ))}
    </ul>
  );
}

function Misread() {
  const { name = "", misreadings = [] } = misread.value ?? {};
  const message = useRef<HTMLDivElement>(null);
  useEffect(() => message.current?.scrollIntoView({ block: "nearest" }), [misreadings]);
  return (
    <div class="message wrong" ref={message}>
      <strong>{word("ownMisreadTitle", { name })}</strong>
      <Close
        onClick={() => {
          misread.value = null;
        }}
      />
      <ul>
        {misreadings.map((misreading) => (
          <li key={JSON.stringify(misreading)}>{spoken(misreading)}</li>
        ))}
      </ul>
    </div>
  );
}

function spoken({ line, column, key, values }: Misreading): string {
  const message = word(key, values);
  if (line === undefined) return message;
  const place = column === undefined ? word("ownLine", { line }) : word("ownPlace", { line, column });
  return `${place}: ${message}`;
}
