/** Names of keys and of their words, as people read them. */

import { word } from "../words";
import { en, type Word } from "../words/en";

/** The name of a key, such as `nose_height`; a key without a word of its own is read as it is. */
export const keyLabel = (key: string) => labelled(`key_${key}`, key);

/** The name of one of several choices, such as `mathavan_2014`. */
export const choiceLabel = (choice: string) => labelled(`choice_${choice}`, choice);

function labelled(key: string, otherwise: string): string {
  if (key in en) return word(key as Word);
  const text = otherwise.replaceAll("_", " ");
  return text.charAt(0).toUpperCase() + text.slice(1);
}
