/** The page in a frame of another one: `?embed` leaves the table and the bar below it. */

export const isEmbedded = new URLSearchParams(window.location.search).has("embed");
