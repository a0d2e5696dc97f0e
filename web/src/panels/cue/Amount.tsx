/** A number with a slider and a box to type it in. */

import { useId } from "preact/hooks";

interface Props {
  label: string;
  value: number;
  min: number;
  max: number;
  /** What an arrow key changes it by, and what it does with Shift. */
  step: number;
  fineStep: number;
  unit: string;
  /** What of a value is written. */
  rounded: (value: number) => number;
  onValue: (value: number) => void;
}

export function Amount({ label, value, min, max, step, fineStep, unit, rounded, onValue }: Props) {
  const id = useId();
  return (
    <div class="amount">
      <label for={id}>{label}</label>
      <span class="typed">
        <input
          id={id}
          type="number"
          step="any"
          value={value}
          onChange={({ currentTarget }) => {
            if (Number.isFinite(currentTarget.valueAsNumber)) onValue(currentTarget.valueAsNumber);
            else currentTarget.value = String(value);
          }}
        />
        <span class="unit">{unit}</span>
      </span>
      <input
        type="range"
        min={min}
        max={max}
        step={fineStep}
        value={value}
        aria-label={label}
        aria-valuetext={`${value} ${unit}`}
        onInput={(event) => onValue(rounded(Number(event.currentTarget.value)))}
        onKeyDown={(event) => {
          const turn = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
          if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
          event.preventDefault();
          onValue(rounded(value + turn * (event.shiftKey ? fineStep : step)));
        }}
      />
    </div>
  );
}
