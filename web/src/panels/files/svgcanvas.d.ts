/** What is used of svgcanvas, which comes without types; the names with underscores are inner ones of this version. */
declare module "svgcanvas" {
  export class Context {
    constructor(options: { width: number; height: number });
    getSerializedSvg(): string;
    getSvg(): SVGSVGElement;
    font: string;
    textAlign: string;
    textBaseline: string;
    __currentElement: Element;
    __createElement(name: string, attributes: Record<string, string | number>, isReset: boolean): Element;
    __closestGroupOrSvg(): Element;
    __applyTransformation(element: Element): void;
    __applyStyleToCurrentElement(action: "fill" | "stroke"): void;
    __applyText(text: string, x: number, y: number, action: "fill" | "stroke"): void;
  }
}
