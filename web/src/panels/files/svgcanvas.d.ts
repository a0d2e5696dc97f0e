/** What is used of svgcanvas, which comes without types. */
declare module "svgcanvas" {
  export class Context {
    constructor(options: { width: number; height: number });
    getSerializedSvg(): string;
  }
}
