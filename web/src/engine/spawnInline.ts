/** Starts the worker from a text within the page: a page that is one file has no other beside it. */
import EngineWorker from "./worker?worker&inline";

export const spawn = (): Worker => new EngineWorker();
