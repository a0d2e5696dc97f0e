/** Opens files and texts. */

import { useSignal } from "@preact/signals";
import { useId, useRef } from "preact/hooks";
import { takeFile, takeText } from "../../sharing/receive";
import { word } from "../../words";

/** A button for a file, with what else brings one to the page. */
export function FromFile() {
  return (
    <>
      <h2>{word("openFile")}</h2>
      <p class="hint">{word("openFileHint")}</p>
      <FileButton />
    </>
  );
}

export function FileButton() {
  const input = useRef<HTMLInputElement>(null);
  return (
    <>
      <button type="button" onClick={() => input.current?.click()}>
        {word("chooseFile")}
      </button>
      <input
        ref={input}
        type="file"
        hidden
        accept=".toml,.json,.csv,.tsv,.txt"
        aria-label={word("chooseFile")}
        onChange={({ currentTarget }) => {
          const file = currentTarget.files?.[0];
          currentTarget.value = "";
          if (file) void takeFile(file);
        }}
      />
    </>
  );
}

export function FromText() {
  const text = useSignal("");
  const id = useId();
  return (
    <form
      class="from-text"
      onSubmit={(event) => {
        event.preventDefault();
        void takeText(text.peek(), "");
      }}
    >
      <label for={id}>{word("pasteText")}</label>
      <textarea
        id={id}
        rows={4}
        spellcheck={false}
        value={text.value}
        onInput={(event) => {
          text.value = event.currentTarget.value;
        }}
      />
      <button type="submit" disabled={text.value.trim() === ""}>
        {word("openText")}
      </button>
    </form>
  );
}
