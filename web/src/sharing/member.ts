/** The text of one member of a JSON object, with every digit as it is written: a parsed number may have fewer. */
export function memberText(json: string, key: string): string | null {
  const quoted = JSON.stringify(key);
  const tokens = /"[^"\\]*(?:\\.[^"\\]*)*"|[[\]{},:]/gs;
  let [depth, start, isMember] = [0, -1, false];
  for (let token = tokens.exec(json); token; token = tokens.exec(json)) {
    const [mark] = token;
    if (mark === "{" || mark === "[") depth++;
    else if (mark === "}" || mark === "]") depth--;
    const isOver = start >= 0 && (depth < 1 || (depth === 1 && mark === ","));
    if (isOver) return json.slice(start, token.index).trim();
    if (start >= 0) continue;
    if (isMember && mark === ":") start = tokens.lastIndex;
    isMember = depth === 1 && mark === quoted;
  }
  return null;
}
