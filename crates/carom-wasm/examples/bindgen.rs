//! Makes what the page loads of the compiled engine: `bindgen ENGINE.wasm FOLDER`.
//!
//! The tool of that name does the same and much else, for which it builds a web client and a server.

use std::error::Error;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (Some(engine), Some(folder)) = (arguments.next(), arguments.next()) else {
        return Err("usage: bindgen ENGINE.wasm FOLDER".into());
    };
    Bindgen::new()
        .input_path(engine)
        .web(true)?
        .omit_default_module_path(true)
        .typescript(true)
        .generate(folder)?;
    Ok(())
}
