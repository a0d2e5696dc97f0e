/** Starts the worker from a file beside the page. */
import EngineWorker from "./worker?worker";

export const spawn = (): Worker => new EngineWorker();
