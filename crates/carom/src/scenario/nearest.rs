//! "Did you mean ...": the known word nearest to a misspelt one.

/// Words that people bring from elsewhere, and what they are called here.
const CALLED_HERE: [(&str, &str); 27] = [
    ("angle", "direction_deg"),
    ("angle_deg", "direction_deg"),
    ("phi", "direction_deg"),
    ("phi_deg", "direction_deg"),
    ("theta", "direction_deg"),
    ("v0", "V0"),
    ("cue_ball_id", "cue_ball"),
    ("cue_id", "cue_ball"),
    ("omega", "spin"),
    ("angular_velocity", "spin"),
    ("M", "mass"),
    ("m", "mass"),
    ("R", "radius"),
    ("u_s", "sliding_friction"),
    ("u_r", "rolling_friction"),
    ("spacing_factor", "spacing"),
    ("colour", "color"),
    ("height", "length"),
    ("name", "id"),
    ("x0", "position"),
    ("v0", "velocity"),
    ("gravity", "acceleration"),
    ("time", "duration"),
    ("t_end", "duration"),
    ("timestep", "dt"),
    ("count", "n"),
    ("eta", "packing_fraction"),
];

/// How alike two words must be, from 0 (nothing in common) to 1 (the same).
const ALIKE: f64 = 0.5;

/// The known word that was probably meant.
pub(crate) fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    let called_here = CALLED_HERE.iter().filter(|(foreign, _)| *foreign == word).map(|(_, here)| *here);
    let in_degrees = known.iter().copied().find(|candidate| candidate.strip_suffix("_deg") == Some(word));
    let meant = in_degrees.or_else(|| called_here.into_iter().find_map(|here| find(known, here)));
    if meant.is_some() {
        return meant;
    }
    let mut best = None;
    let mut likeness = ALIKE;
    for candidate in known {
        let this = strsim::normalized_damerau_levenshtein(word, candidate);
        if this > likeness {
            (best, likeness) = (Some(*candidate), this);
        }
    }
    best
}

fn find<'a>(known: &[&'a str], word: &str) -> Option<&'a str> {
    known.iter().copied().find(|candidate| *candidate == word)
}

/// "; did you mean this?" where a near word is known, and the list of all known ones where it is not too long.
pub(crate) fn suggestion(word: &str, known: &[&str]) -> String {
    let mut text = nearest(word, known).map_or_else(String::new, |near| format!("; did you mean {near}?"));
    if known.len() <= 20 && !known.is_empty() {
        text += &format!(" known: {}", known.join(", "));
        if text.starts_with(' ') {
            text.insert(0, ';');
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{nearest, suggestion};

    #[test]
    fn the_nearest_word_is_found_or_none() {
        let known = ["position", "velocity", "speed", "direction_deg"];
        assert_eq!(nearest("positon", &known), Some("position"));
        assert_eq!(nearest("direction", &known), Some("direction_deg"));
        assert_eq!(nearest("phi", &known), Some("direction_deg"));
        assert_eq!(nearest("phi", &["position"]), None);
        assert_eq!(nearest("theta", &["direction_deg", "theta_deg"]), Some("theta_deg"));
        assert_eq!(nearest("v0", &["V0", "velocity"]), Some("V0"));
        assert_eq!(nearest("v0", &known), Some("velocity"));
        assert_eq!(nearest("from", &["radius", "from_deg", "to_deg"]), Some("from_deg"));
        assert_eq!(nearest("zzz", &known), None);
    }

    #[test]
    fn a_suggestion_names_the_nearest_and_all_known_words() {
        assert_eq!(
            suggestion("elastc", &["elastic", "free"]),
            "; did you mean elastic? known: elastic, free"
        );
        assert_eq!(suggestion("q", &["elastic", "free"]), "; known: elastic, free");
        assert_eq!(suggestion("q", &[]), "");
    }
}
