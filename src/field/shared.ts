/**
 * Plain data with the very objects of what was before it wherever both say the same: what came by message is a copy, and trees that share
 * their objects are compared by reference, and keep what was bound of them.
 */

/** `after`, of objects of `before` as far as possible; items of lists may have moved. */
export function shared<T>(before: unknown, after: T): T {
  if (before === after || !isObject(before) || !isObject(after)) return after;
  if (keyOf(before) === keyOf(after)) return before as T;
  if (Array.isArray(after)) return sharedList(Array.isArray(before) ? before : [], after) as T;
  const entries = Object.entries(after).map(([name, value]) => [name, shared(before[name], value)]);
  return Object.fromEntries(entries) as T;
}

function sharedList(before: readonly unknown[], after: readonly unknown[]): readonly unknown[] {
  if (!after.some(isObject)) return after;
  const known = new Map<string, unknown[]>();
  for (const item of before.toReversed()) {
    const key = keyOf(item);
    known.set(key, [...(known.get(key) ?? []), item]);
  }
  const same = after.map((item) => known.get(keyOf(item))?.pop());
  const left = new Set(before);
  for (const item of same) left.delete(item);
  // what changed is most likely in the place of what it was
  return after.map((item, i) => same[i] ?? shared(left.has(before[i]) ? before[i] : null, item));
}

const keyOf = (value: unknown): string => JSON.stringify(value);

const isObject = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === 'object' && value !== null;
