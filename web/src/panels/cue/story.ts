/** What came of a shot, as far as its events tell. */

import type { Shown } from "../../studio/store";

/** Balls by their places in the list. */
export interface Story {
  /** The balls that the cue ball hit, each once, in order. */
  hits: number[];
  /** Contacts of the cue ball with cushions before it first hit a ball, and after. */
  cushionsBefore: number;
  cushionsAfter: number;
  /** Contacts of all balls with cushions. */
  cushions: number;
  /** Balls with the pockets that they fell into, and when. */
  pocketed: [ball: number, pocket: string, time: number][];
  offTable: number[];
}

export function storyOf({ events }: Shown, cueBall: number, kinds: string[]): Story {
  const story: Story = {
    hits: [],
    cushionsBefore: 0,
    cushionsAfter: 0,
    cushions: 0,
    pocketed: [],
    offTable: [],
  };
  events.kind.forEach((kind, k) => {
    const [a, b] = [events.ballA[k] as number, events.ballB[k] as number];
    tell(story, kinds[kind] ?? "", cueBall, a, b);
    if (kinds[kind] === "ball_pocket") {
      const pocket = events.pocketIds[events.pocket[k] as number] ?? "";
      story.pocketed.push([a, pocket, events.time[k] as number]);
    }
  });
  return story;
}

function tell(story: Story, kind: string, cueBall: number, a: number, b: number) {
  if (kind === "off_table") story.offTable.push(a);
  else if (kind === "ball_ball" && (a === cueBall || b === cueBall)) {
    const other = a === cueBall ? b : a;
    if (!story.hits.includes(other)) story.hits.push(other);
  } else if (kind === "ball_cushion") {
    story.cushions++;
    if (a !== cueBall) return;
    if (story.hits.length === 0) story.cushionsBefore++;
    else story.cushionsAfter++;
  }
}
