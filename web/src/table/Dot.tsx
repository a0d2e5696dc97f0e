/** A ball in a line of text. */
export function Dot({ colour }: { colour: string }) {
  return (
    <svg class="dot" viewBox="0 0 12 12" width="12" height="12" aria-hidden="true">
      <circle cx="6" cy="6" r="5" fill={colour} stroke="currentColor" stroke-opacity="0.6" />
    </svg>
  );
}
