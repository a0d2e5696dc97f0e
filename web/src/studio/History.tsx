/** Undo and redo: two buttons and their keys. */

import { useEffect } from "preact/hooks";
import { word } from "../words";
import { Icon } from "./Icon";
import { canRedo, canUndo, redo, undo } from "./store";

export function History() {
  useEffect(() => {
    document.addEventListener("keydown", onKey);
    return () => document.removeEventListener("keydown", onKey);
  }, []);
  return (
    <>
      <HistoryButton name="undo" isThere={canUndo.value} onClick={undo} />
      <HistoryButton name="redo" isThere={canRedo.value} onClick={redo} />
    </>
  );
}

function HistoryButton(props: { name: "undo" | "redo"; isThere: boolean; onClick: () => void }) {
  const { name, isThere, onClick } = props;
  return (
    <button
      type="button"
      class="icon quiet"
      title={word(name)}
      aria-label={word(name)}
      disabled={!isThere}
      onClick={onClick}
    >
      <Icon name={name} />
    </button>
  );
}

/** Where text is typed, the keys take back what was typed. */
function isTyping(target: EventTarget | null): boolean {
  if (target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && ["text", "number", "search"].includes(target.type);
}

function onKey(event: KeyboardEvent) {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || isTyping(event.target)) return;
  const key = event.key.toLowerCase();
  if (key !== "z" && key !== "y") return;
  event.preventDefault();
  if (key === "y" || event.shiftKey) redo();
  else undo();
}
