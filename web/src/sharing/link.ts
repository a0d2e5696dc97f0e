/**
 * A scenario as the fragment of a link: two lines of JSON, deflated, as letters. The first line says what the link is
 * from, the second is the scenario with every digit that it has.
 */

import type { Claim } from "../studio/store";
import type { Word } from "../words/en";
import { fromBase64url, toBase64url } from "./base64url";
import { deflated, inflated, TooLong } from "./deflate";

/** What a fragment with a scenario begins with. */
export const MARK = "scenario=";

const FORMAT = 1;
/** Browsers differ in what they take; none takes more. */
export const LONGEST_LINK = 2_000_000;
/** Bytes of the two lines. */
const LONGEST_TEXT = 4 * 2 ** 20;

/** A link that cannot be opened, and why. */
export class BadLink extends Error {
  constructor(readonly reason: Word) {
    super(reason);
  }
}

interface Head {
  format: number;
  physics_version: number;
  digest: string | null;
}

/** The fragment, without its #, of a scenario and of the digest of its run. */
export async function fragmentOf(
  json: string,
  digest: string | null,
  physicsVersion: number,
): Promise<string> {
  const head: Head = { format: FORMAT, physics_version: physicsVersion, digest };
  return MARK + toBase64url(await deflated(`${JSON.stringify(head)}\n${json}`));
}

/** The scenario of a fragment, as JSON text, and what the link says of its run. */
export async function readFragment(fragment: string): Promise<{ json: string; claim: Claim }> {
  if (fragment.length > LONGEST_LINK) throw new BadLink("linkTooLong");
  const bytes = fromBase64url(fragment.slice(MARK.length));
  if (!bytes) throw new BadLink("linkBroken");
  const text = await inflated(bytes, LONGEST_TEXT).catch((error: unknown) => {
    throw new BadLink(error instanceof TooLong ? "linkTooLarge" : "linkBroken");
  });
  const end = text.indexOf("\n");
  const { physics_version, digest } = checkedHead(text.slice(0, Math.max(end, 0)));
  return { json: text.slice(end + 1), claim: { fragment, digest, physicsVersion: physics_version } };
}

function checkedHead(line: string): Head {
  let head: Partial<Head> | null;
  try {
    head = JSON.parse(line);
  } catch {
    head = null;
  }
  if (!Number.isInteger(head?.format)) throw new BadLink("linkBroken");
  if ((head?.format as number) > FORMAT) throw new BadLink("linkTooNew");
  const { physics_version, digest = null } = head as Head;
  const isRight = Number.isInteger(physics_version) && (digest === null || typeof digest === "string");
  if (!isRight) throw new BadLink("linkBroken");
  return head as Head;
}
