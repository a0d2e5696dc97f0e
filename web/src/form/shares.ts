/** Members of a list that share something out among them: what one of them gets, its neighbour gives. */

import type { Values } from "../engine/protocol";
import { written } from "../studio/store";
import { pathOf, type Step, valueAt, withValue } from "./paths";

/** The keys that say how much a member has: all members together have 1, or the number of discs. */
const SHARES = ["fraction", "number"];

type Member = Record<string, number>;

const shareOf = (member: unknown): string | undefined =>
  SHARES.find((key) => valueAt(member, [key]) !== undefined);

/** Without what sums of decimal fractions leave over. */
const rounded = (share: number) => Number(share.toPrecision(12));

/** The change that sets a share, with that of the neighbour; null for other places. */
export function movedShare(steps: readonly Step[], share: number | undefined): Values | null {
  const [at, key] = steps.slice(-2);
  const around = steps.slice(0, -2);
  const list = valueAt(written.peek(), around) as Member[] | undefined;
  if (typeof at !== "number" || !Array.isArray(list) || shareOf(list[at]) !== key) return null;
  if (list.length < 2 || key === undefined || share === undefined) return null;
  const moved = given(list, (at + 1) % list.length, String(key), (list[at]?.[key] ?? 0) - share);
  return { [pathOf(around)]: withValue(moved, [at, key], share) };
}

const given = (list: Member[], to: number, key: string, more: number): Member[] =>
  withValue(list, [to, key], rounded((list[to]?.[key] ?? 0) + more)) as Member[];

/** Whether the members of a list share something out. */
export const hasShares = (list: unknown[]): boolean => shareOf(list[0]) !== undefined;

/** The list with another member, like the last one, that has nothing yet. */
export function withNewcomer(list: unknown[]): unknown[] {
  const key = shareOf(list[0]) ?? "";
  return [...list, { ...(list.at(-1) as Member), [key]: 0 }];
}

/** The list without a member, whose share its neighbour gets. */
export function withoutShare(list: unknown[], at: number): unknown[] {
  const key = shareOf(list[at]) ?? "";
  const share = (list[at] as Member)[key] ?? 0;
  return given(list as Member[], (at + 1) % list.length, key, share).toSpliced(at, 1);
}
