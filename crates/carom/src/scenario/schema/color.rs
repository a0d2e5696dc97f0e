//! Colours of balls.

use crate::scenario::nearest::nearest;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A colour: one of the 148 colour names of CSS, "#rgb" or "#rrggbb" in hexadecimal digits, or [red, green, blue] with
/// numbers from 0 to 1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Color {
    /// A name such as "crimson", or "#rgb" or "#rrggbb".
    Text(String),
    /// [red, green, blue], each from 0 to 1.
    Rgb(#[schemars(inner(range(min = 0.0, max = 1.0)))] [f64; 3]),
}

impl Color {
    /// Whether this is a colour; if not, what is wrong.
    pub fn check(&self) -> Result<(), String> {
        let Color::Text(text) = self else { return Ok(()) };
        let lowercase = text.to_ascii_lowercase();
        let known = match text.strip_prefix('#') {
            Some(digits) => {
                [3, 6].contains(&digits.len()) && digits.chars().all(|digit| digit.is_ascii_hexdigit())
            }
            None => COLOR_NAMES.contains(&lowercase.as_str()),
        };
        if known {
            return Ok(());
        }
        let near = nearest(&lowercase, &COLOR_NAMES)
            .map_or_else(String::new, |near| format!("; did you mean {near}?"));
        Err(format!("{text:?} is no CSS colour name, #rgb or #rrggbb{near}"))
    }
}

/// The colour names of CSS (Color Module Level 4), in order; matplotlib knows the same ones.
#[rustfmt::skip]
pub const COLOR_NAMES: [&str; 148] = [
    "aliceblue", "antiquewhite", "aqua", "aquamarine", "azure", "beige", "bisque", "black",
    "blanchedalmond", "blue", "blueviolet", "brown", "burlywood", "cadetblue", "chartreuse",
    "chocolate", "coral", "cornflowerblue", "cornsilk", "crimson", "cyan", "darkblue", "darkcyan",
    "darkgoldenrod", "darkgray", "darkgreen", "darkgrey", "darkkhaki", "darkmagenta", "darkolivegreen",
    "darkorange", "darkorchid", "darkred", "darksalmon", "darkseagreen", "darkslateblue",
    "darkslategray", "darkslategrey", "darkturquoise", "darkviolet", "deeppink", "deepskyblue",
    "dimgray", "dimgrey", "dodgerblue", "firebrick", "floralwhite", "forestgreen", "fuchsia",
    "gainsboro", "ghostwhite", "gold", "goldenrod", "gray", "green", "greenyellow", "grey", "honeydew",
    "hotpink", "indianred", "indigo", "ivory", "khaki", "lavender", "lavenderblush", "lawngreen",
    "lemonchiffon", "lightblue", "lightcoral", "lightcyan", "lightgoldenrodyellow", "lightgray",
    "lightgreen", "lightgrey", "lightpink", "lightsalmon", "lightseagreen", "lightskyblue",
    "lightslategray", "lightslategrey", "lightsteelblue", "lightyellow", "lime", "limegreen", "linen",
    "magenta", "maroon", "mediumaquamarine", "mediumblue", "mediumorchid", "mediumpurple",
    "mediumseagreen", "mediumslateblue", "mediumspringgreen", "mediumturquoise", "mediumvioletred",
    "midnightblue", "mintcream", "mistyrose", "moccasin", "navajowhite", "navy", "oldlace", "olive",
    "olivedrab", "orange", "orangered", "orchid", "palegoldenrod", "palegreen", "paleturquoise",
    "palevioletred", "papayawhip", "peachpuff", "peru", "pink", "plum", "powderblue", "purple",
    "rebeccapurple", "red", "rosybrown", "royalblue", "saddlebrown", "salmon", "sandybrown", "seagreen",
    "seashell", "sienna", "silver", "skyblue", "slateblue", "slategray", "slategrey", "snow",
    "springgreen", "steelblue", "tan", "teal", "thistle", "tomato", "turquoise", "violet", "wheat",
    "white", "whitesmoke", "yellow", "yellowgreen",
];
