//! The page around the data: one HTML file with our own styles and scripts, nothing fetched.
//!
//! The content security policy lets nothing in: no connection, no script but the one whose hash it names, no frame but the page's own
//! documents, which get it too and are sandboxed. Data is JSON and base64 in elements that are never run; the scripts write it as text.

use base64::prelude::{BASE64_STANDARD, Engine};
use sha2::{Digest, Sha256};

use super::{Packed, Report};
use crate::price::escape;

/// The skeleton, with `{{...}}` where the parts go.
const SHELL: &str = include_str!("page/shell.html");

/// The styles in their order.
const STYLES: [&str; 4] = [
    include_str!("page/base.css"),
    include_str!("page/explore.css"),
    include_str!("page/house.css"),
    include_str!("page/print.css"),
];

/// The scripts in their order; each is a noun, and they share one scope.
const SCRIPTS: [&str; 22] = [
    include_str!("page/dom.js"),
    include_str!("page/number.js"),
    include_str!("page/data.js"),
    include_str!("page/theme.js"),
    include_str!("page/state.js"),
    include_str!("page/brush.js"),
    include_str!("page/axis.js"),
    include_str!("page/scatter.js"),
    include_str!("page/parallel.js"),
    include_str!("page/handles.js"),
    include_str!("page/grid.js"),
    include_str!("page/named.js"),
    include_str!("page/matrix.js"),
    include_str!("page/glb.js"),
    include_str!("page/shader.js"),
    include_str!("page/renderer.js"),
    include_str!("page/viewer.js"),
    include_str!("page/chosen.js"),
    include_str!("page/dossier.js"),
    include_str!("page/compare.js"),
    include_str!("page/findings.js"),
    include_str!("page/texts.js"),
];

/// What starts them.
const START: &str = include_str!("page/main.js");

/// `report.html`.
///
/// # Errors
/// When a figure cannot be written as JSON.
pub fn report_html(report: &Report, packed: &[Packed]) -> Result<String, serde_json::Error> {
    let script = script();
    let digest = BASE64_STANDARD.encode(Sha256::digest(script.as_bytes()));
    // `<` never occurs in the data, so that no text in it ends its element.
    let data = serde_json::to_string(report)?.replace('<', "\\u003c");
    let (pictures, files): (Vec<&Packed>, Vec<&Packed>) = packed.iter().partition(|p| p.key.ends_with("/thumb.png"));
    let stored = |list: Vec<&Packed>| -> String {
        let one = |p: &&Packed| format!("<script type=\"text/plain\" id=\"{}\">{}</script>\n", escape(&p.key), p.data);
        list.iter().map(one).collect()
    };
    let parts = [
        ("{{title}}", escape(&report.name)),
        ("{{digest}}", digest),
        ("{{styles}}", STYLES.concat()),
        ("{{data}}", data),
        ("{{script}}", script),
        ("{{pictures}}", stored(pictures)),
        ("{{files}}", stored(files)),
    ];
    // One pass over the skeleton, so that nothing in the data is taken for a place of another part.
    let mut page = String::with_capacity(parts.iter().map(|p| p.1.len()).sum::<usize>() + SHELL.len());
    let mut rest = SHELL;
    while let Some(at) = rest.find("{{") {
        page += &rest[..at];
        rest = &rest[at..];
        match parts.iter().find(|(place, _)| rest.starts_with(place)) {
            Some((place, text)) => {
                page += text;
                rest = &rest[place.len()..];
            }
            None => {
                page += "{{";
                rest = &rest[2..];
            }
        }
    }
    Ok(page + rest)
}

/// All scripts in one scope of their own.
fn script() -> String {
    format!("\"use strict\";\n(() => {{\n{}{START}}})();\n", SCRIPTS.concat())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_part_of_ours_ends_its_element() {
        assert!(!script().contains("</script") && !script().contains("<!--"));
        assert!(
            STYLES
                .iter()
                .all(|style| !style.contains("</style") && !style.contains("url(") && !style.contains("@import"))
        );
    }

    #[test]
    fn every_place_of_the_skeleton_is_known() {
        for place in ["title", "digest", "styles", "data", "script", "pictures", "files"] {
            assert!(SHELL.contains(&format!("{{{{{place}}}}}")), "{place}");
        }
        assert!(!SHELL.contains("://") && !script().contains("://"), "nothing is fetched");
    }
}
