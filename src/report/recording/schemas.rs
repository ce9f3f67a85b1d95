//! Foxglove's messages as JSON schemas: those fields of them that are written here.

use serde_json::{Value, json};

/// The schema of `foxglove.NAME`.
pub(super) fn of(name: &str) -> String {
    let (what, properties) = match name {
        "FrameTransforms" => ("Frames, each in its parent", json!({ "transforms": list(transform()) })),
        "PosesInFrame" => {
            let pose = object(json!({ "position": vector(), "orientation": quaternion() }));
            let poses = json!({ "timestamp": time(), "frame_id": { "type": "string" }, "poses": list(pose) });
            ("Poses in one frame", poses)
        }
        _ => {
            let text = json!({ "type": "string" });
            let log = json!({
                "timestamp": time(), "level": { "type": "integer" }, "message": text, "name": text, "file": text,
                "line": { "type": "integer", "minimum": 0 },
            });
            ("A line of a log", log)
        }
    };
    let schema = json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema", "title": format!("foxglove.{name}"),
        "description": what, "type": "object", "properties": properties,
    });
    schema.to_string()
}

fn object(properties: Value) -> Value {
    json!({ "type": "object", "properties": properties })
}

fn list(items: Value) -> Value {
    json!({ "type": "array", "items": items })
}

fn numbers(names: &[&str]) -> Value {
    object(names.iter().map(|name| ((*name).to_owned(), json!({ "type": "number" }))).collect())
}

fn vector() -> Value {
    numbers(&["x", "y", "z"])
}

fn quaternion() -> Value {
    numbers(&["x", "y", "z", "w"])
}

fn time() -> Value {
    object(
        json!({ "sec": { "type": "integer", "minimum": 0 }, "nsec": { "type": "integer", "minimum": 0, "maximum": 999_999_999 } }),
    )
}

fn transform() -> Value {
    let text = json!({ "type": "string" });
    object(json!({
        "timestamp": time(), "parent_frame_id": text, "child_frame_id": text, "translation": vector(), "rotation": quaternion(),
    }))
}
