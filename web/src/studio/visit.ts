/** What is remembered for the visit: the tab's own store, which ends with it. Frames may have none. */

export function remembered(key: string): string | null {
  try {
    return sessionStorage.getItem(key);
  } catch {
    return null;
  }
}

export function remember(key: string, value: string) {
  try {
    sessionStorage.setItem(key, value);
  } catch {
    // The choice then lasts until the page is left.
  }
}
