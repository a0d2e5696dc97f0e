/** In the place of the worker: what plays a recorded run computes nothing, and asks for nothing. */

export const spawn = (): Worker =>
  ({ postMessage() {}, terminate() {}, addEventListener() {} }) as unknown as Worker;
