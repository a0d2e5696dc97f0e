/** The lessons, in the order of the gallery. A new one is a file and a line here. */

import { butterfly } from "./butterfly";
import { momentum } from "./momentum";
import { pi } from "./pi";
import { timestep } from "./timestep";
import type { Lesson } from "./types";

export const lessons: Lesson[] = [timestep, momentum, pi, butterfly];
