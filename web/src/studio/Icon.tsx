/** Icons, drawn on a grid of 24. */

const PATHS: Record<string, string> = {
  play: "M8 5v14l11-7z",
  pause: "M7 5h4v14H7zM14 5h4v14h-4z",
  start: "M6 5h2v14H6zM19 5v14L9 12z",
  end: "M16 5h2v14h-2zM5 5v14l10-7z",
  previous: "M5 11h9V6l6 6-6 6v-5H5z",
  next: "M5 11h9V6l6 6-6 6v-5H5z",
  close: "M6 4.6 12 10.6 18 4.6 19.4 6 13.4 12 19.4 18 18 19.4 12 13.4 6 19.4 4.6 18 10.6 12 4.6 6z",
  theme: "M12 3a9 9 0 1 0 0 18 9 9 0 0 0 0-18zm0 2.2a6.8 6.8 0 0 1 0 13.6z",
  keys: "M3 6h18v12H3zm2 2v2h2V8zm4 0v2h2V8zm4 0v2h2V8zm4 0v2h2V8zM5 11.5v2h2v-2zm4 0v2h2v-2zm4 0v2h2v-2zm4 0v2h2v-2zM8 15v1.5h8V15z",
  undo: "M9 6 4 11l5 5v-4h6a3.5 3.5 0 0 1 0 7h-3v2h3a5.5 5.5 0 0 0 0-11H9z",
  redo: "m15 6 5 5-5 5v-4H9a3.5 3.5 0 0 0 0 7h3v2H9a5.5 5.5 0 0 1 0-11h6z",
};

/** Icons that are another one turned round. */
const TURNED = new Set(["previous"]);

export function Icon({ name }: { name: string }) {
  return (
    <svg
      viewBox="0 0 24 24"
      width="20"
      height="20"
      aria-hidden="true"
      class={TURNED.has(name) ? "turned" : ""}
    >
      <path d={PATHS[name] ?? ""} fill="currentColor" fill-rule="evenodd" />
    </svg>
  );
}
