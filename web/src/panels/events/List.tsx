// biome-ignore-all lint/a11y/useSemanticElements: the rows of a table element cannot be placed one by one

/** The event log as a list, of which only the rows in view are there. */

import { useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { drawing, run } from "../../studio/store";
import { withUnit } from "../../studio/units";
import { ballColours } from "../../table/colours";
import { Dot } from "../../table/Dot";
import { number, word } from "../../words";
import { eventOf, goTo, kindWord, placeOf, rowCount, rowNow } from "./log";

/** Pixels of a row, and of the row of names above. */
const ROW = 44;
const HEAD = 52;
/** Rows beyond both ends of what is in view. */
const BEYOND = 4;
/** Browsers know no heights far above this; in a longer list a pixel of the scroll bar is more than one of the rows. */
const TALLEST = 8_000_000;

export function List() {
  const box = useRef<HTMLDivElement>(null);
  const scrolled = useSignal(0);
  const room = useSignal(300);
  const count = rowCount.value;
  const span = spanOf(count, room.value);
  const offset = span.offsetOf(scrolled.value);

  useEffect(() => {
    const element = box.current;
    if (!element) return;
    const observer = new ResizeObserver(() => {
      room.value = element.clientHeight - HEAD;
    });
    observer.observe(element);
    return () => observer.disconnect();
  }, []);

  const now = rowNow.value;
  useEffect(() => {
    const element = box.current;
    if (!element || now < 0) return;
    const current = span.offsetOf(element.scrollTop);
    const [above, below] = [now * ROW, (now + 1) * ROW - room.peek()];
    if (above < current) element.scrollTop = span.scrollOf(above);
    else if (below > current) element.scrollTop = span.scrollOf(below);
  }, [now, count]);

  const first = Math.max(0, Math.floor(offset / ROW) - BEYOND);
  const last = Math.min(count - 1, Math.ceil((offset + room.value) / ROW) + BEYOND);
  const rows = Array.from({ length: Math.max(last - first + 1, 0) }, (_, k) => first + k);
  return (
    <div
      class="log"
      ref={box}
      style={{ "--digits": String(Math.max(count - 1, 0)).length }}
      role="grid"
      tabIndex={0}
      aria-label={word("events")}
      aria-rowcount={count + 1}
      aria-activedescendant={now >= first && now <= last ? `event-${now}` : undefined}
      onScroll={(event) => {
        scrolled.value = event.currentTarget.scrollTop;
      }}
      onKeyDown={(event) => {
        const step = Math.max(1, Math.floor(room.peek() / ROW) - 1);
        const target = targetOf(event.key, now, count, step);
        if (target === null) return;
        event.preventDefault();
        event.stopPropagation();
        goTo(target);
      }}
    >
      <Head />
      <div role="rowgroup" class="rows" style={{ height: `${span.height}px` }}>
        {rows.map((row) => (
          <Row key={row} row={row} top={row * ROW - offset + scrolled.value} isNow={row === now} />
        ))}
      </div>
    </div>
  );
}

/** How the scroll bar and the rows go together. */
function spanOf(count: number, room: number) {
  const content = count * ROW;
  const height = Math.min(content, TALLEST);
  const stretch = content > height ? (content - room) / (height - room) : 1;
  return {
    height,
    offsetOf: (scroll: number) => scroll * stretch,
    scrollOf: (offset: number) => offset / stretch,
  };
}

/** The row that a key leads to; null where it is no such key. */
function targetOf(key: string, now: number, count: number, page: number): number | null {
  const targets: Record<string, number> = {
    ArrowDown: now + 1,
    ArrowUp: now - 1,
    PageDown: now + page,
    PageUp: now - page,
    Home: 0,
    End: count - 1,
    Enter: now,
  };
  return targets[key] ?? null;
}

function Head() {
  const names = [
    word("eventIndex"),
    withUnit(word("timeShort"), "time"),
    word("event"),
    withUnit(word("closingSpeed"), "speed"),
    withUnit(word("impulse"), "momentum"),
  ];
  return (
    <div role="row" class="log-row head" aria-rowindex={1} tabIndex={-1}>
      {names.map((name) => (
        <span role="columnheader" key={name} tabIndex={-1}>
          {name}
        </span>
      ))}
    </div>
  );
}

function Row({ row, top, isNow }: { row: number; top: number; isNow: boolean }) {
  const events = run.value?.events;
  const balls = drawing.value?.balls ?? [];
  const colours = useMemo(() => ballColours(balls), [balls]);
  if (!events) return null;
  const event = eventOf(row);
  const at = (column: Float64Array) => column[event] as number;
  const pair = [events.ballA[event] as number, events.ballB[event] as number].filter((ball) => ball >= 0);
  const [place, impulse] = [placeOf(events, event), at(events.impulse)];
  return (
    // biome-ignore lint/a11y/useKeyWithClickEvents: the list hears the keys
    <div
      role="row"
      id={`event-${row}`}
      class={isNow ? "log-row now" : "log-row"}
      aria-rowindex={row + 2}
      aria-selected={isNow}
      tabIndex={-1}
      style={{ transform: `translateY(${top}px)` }}
      onClick={() => goTo(row)}
    >
      <Cell>{event}</Cell>
      <Cell>{number(at(events.time), 5)}</Cell>
      <Cell>
        <span class="kind">{kindWord(events.kind[event] as number)}</span>
        <span class="who">
          {pair.map((ball) => (
            <span key={ball}>
              <Dot colour={colours[ball] ?? ""} /> {balls[ball]?.id}
            </span>
          ))}
          {place && <span>→ {place}</span>}
        </span>
      </Cell>
      <Cell>{impulse === 0 ? "" : number(at(events.closingSpeed), 3)}</Cell>
      <Cell>{impulse === 0 ? "" : number(impulse, 3)}</Cell>
    </div>
  );
}

function Cell({ children }: { children: preact.ComponentChildren }) {
  return (
    <span role="gridcell" tabIndex={-1}>
      {children}
    </span>
  );
}
