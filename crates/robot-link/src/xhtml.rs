//! Answers as XHTML: `<li class="TYPE" title="TITLE"><span class="FIELD">value</span>`.

use crate::contents::{Contents, ResourceState};
use roxmltree::{Document, Node, ParsingOptions};

pub(crate) fn parse(text: &str) -> Result<Contents, String> {
    let options = ParsingOptions { allow_dtd: true, nodes_limit: 1_000_000, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|e| e.to_string())?;
    let mut contents = Contents::default();
    for node in document.descendants().filter(Node::is_element) {
        let class = node.attribute("class").unwrap_or_default();
        match node.tag_name().name() {
            "li" if !class.is_empty() => {
                let fields = spans(node).chain(links(node)).collect();
                let title = node.attribute("title").unwrap_or_default().to_owned();
                contents.states.push(ResourceState { class: class.to_owned(), title, fields });
            }
            "div" if class == "status" => {
                for (name, value) in spans(node) {
                    match name.as_str() {
                        "code" => contents.code = value.trim().parse().ok(),
                        "msg" => contents.message = value,
                        _ => {}
                    }
                }
            }
            "a" if node.attribute("rel") == Some("next") => {
                contents.next = node.attribute("href").map(str::to_owned);
            }
            "a" if node.attribute("rel") == Some("error") => {
                let code = node.attribute("href").and_then(|href| href.rsplit_once("code="));
                contents.code = code.and_then(|(_, code)| code.parse().ok());
                contents.is_error = true;
            }
            _ => {}
        }
    }
    Ok(contents)
}

fn spans<'a>(node: Node<'a, 'a>) -> impl Iterator<Item = (String, String)> + 'a {
    node.children().filter(|n| n.has_tag_name_any("span")).filter_map(|span| {
        let text: String = span.descendants().filter_map(|n| n.text().filter(|_| n.is_text())).collect();
        Some((span.attribute("class")?.to_owned(), text))
    })
}

/// What a list entry leads to, under the name `href`.
fn links<'a>(node: Node<'a, 'a>) -> impl Iterator<Item = (String, String)> + 'a {
    let own = node.children().filter(|n| n.has_tag_name_any("a") && n.attribute("rel") == Some("self"));
    own.filter_map(|a| Some(("href".to_owned(), a.attribute("href")?.to_owned())))
}

trait AnyNamespace {
    fn has_tag_name_any(&self, name: &str) -> bool;
}

impl AnyNamespace for Node<'_, '_> {
    fn has_tag_name_any(&self, name: &str) -> bool {
        self.is_element() && self.tag_name().name() == name
    }
}
