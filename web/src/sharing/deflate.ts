/** Text made small, and back to its size, but no larger than is wanted. */

/** Bytes that are inflated at once. Each may become a thousand, so that a bomb is noticed after a few. */
const PART = 4096;

export async function deflated(text: string): Promise<Uint8Array> {
  const stream = new Blob([text]).stream().pipeThrough(new CompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

/** The text is longer than was wanted. */
export class TooLong extends Error {}

/** The text of deflated bytes; throws `TooLong` where it has more than so many bytes, and otherwise if it is broken. */
export async function inflated(bytes: Uint8Array<ArrayBuffer>, most: number): Promise<string> {
  let at = 0;
  const parts = new ReadableStream<BufferSource>({
    pull(controller) {
      if (at >= bytes.length) return controller.close();
      controller.enqueue(bytes.subarray(at, at + PART));
      at += PART;
    },
  });
  const reader = parts.pipeThrough(new DecompressionStream("deflate-raw")).getReader();
  const decoder = new TextDecoder("utf-8", { fatal: true });
  let [text, length] = ["", 0];
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    length += value.length;
    if (length > most) {
      reader.cancel().catch(() => {});
      throw new TooLong();
    }
    text += decoder.decode(value, { stream: true });
  }
}
