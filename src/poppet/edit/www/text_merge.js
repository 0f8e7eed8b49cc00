/* Two changes of one text. */

/* Return a text with the changes from `base` to `typed` and from `base` to `present`, or null if both change the same
   place. */
export function merged(base, typed, present) {
  if (typed === base) return present;
  if (present === base || present === typed) return typed;
  const [first, second] = [changeOf(base, typed), changeOf(base, present)].sort((a, b) => a.start - b.start || a.end - b.end);
  if (first.end > second.start || first.start === second.start) return null;
  return base.slice(0, first.start) + first.text + base.slice(first.end, second.start) + second.text + base.slice(second.end);
}

/* Piece of a text that is replaced, and the new piece. */
function changeOf(before, after) {
  const shorter = Math.min(before.length, after.length);
  let start = 0, same = 0;
  while (start < shorter && before[start] === after[start]) start++;
  while (same < shorter - start && before[before.length - 1 - same] === after[after.length - 1 - same]) same++;
  return { start, end: before.length - same, text: after.slice(start, after.length - same) };
}
