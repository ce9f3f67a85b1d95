//! Foxglove's schemas as a recording carries them: descriptors of Protobuf files, each with what it imports.

use prost::Message;
use prost_types::field_descriptor_proto::{Label, Type};
use prost_types::{
    DescriptorProto, EnumDescriptorProto, EnumValueDescriptorProto, FieldDescriptorProto,
    FileDescriptorProto, FileDescriptorSet,
};

const TIMESTAMP: &str = "google.protobuf.Timestamp";

/// A field: name, type, and of which message or enumeration where it is of one.
type Field = (&'static str, Type, &'static str);

/// The schema of `foxglove.NAME`, as MCAP wants it of Protobuf: a set of files, what is imported first.
pub(super) fn of(name: &str) -> Vec<u8> {
    use Type::{Double, Enum, Fixed32, Int32, Int64, Message as Of, String as Text};
    let vector = || file("Vector3", &[], &[("x", Double, ""), ("y", Double, ""), ("z", Double, "")]);
    let quaternion = || {
        let fields = [("x", Double, ""), ("y", Double, ""), ("z", Double, ""), ("w", Double, "")];
        file("Quaternion", &[], &fields)
    };
    let pose = ["foxglove.Vector3", "foxglove.Quaternion"];
    let mut files = vec![file(TIMESTAMP, &[], &[("seconds", Int64, ""), ("nanos", Int32, "")])];
    match name {
        "FrameTransforms" => {
            let fields = [
                ("timestamp", Of, TIMESTAMP),
                ("parent_frame_id", Text, ""),
                ("child_frame_id", Text, ""),
                ("translation", Of, "foxglove.Vector3"),
                ("rotation", Of, "foxglove.Quaternion"),
            ];
            let one =
                file("FrameTransform", &["foxglove.Quaternion", "foxglove.Vector3", TIMESTAMP], &fields);
            let mut all =
                file(name, &["foxglove.FrameTransform"], &[("transforms", Of, "foxglove.FrameTransform")]);
            repeated(&mut all, "transforms");
            files.extend([quaternion(), vector(), one, all]);
        }
        "PosesInFrame" => {
            let one = file(
                "Pose",
                &["foxglove.Quaternion", "foxglove.Vector3"],
                &[("position", Of, pose[0]), ("orientation", Of, pose[1])],
            );
            let fields =
                [("timestamp", Of, TIMESTAMP), ("frame_id", Text, ""), ("poses", Of, "foxglove.Pose")];
            let mut all = file(name, &["foxglove.Pose", TIMESTAMP], &fields);
            repeated(&mut all, "poses");
            files.extend([quaternion(), vector(), one, all]);
        }
        _ => {
            let fields = [
                ("timestamp", Of, TIMESTAMP),
                ("level", Enum, "foxglove.Log.Level"),
                ("message", Text, ""),
                ("name", Text, ""),
                ("file", Text, ""),
                ("line", Fixed32, ""),
            ];
            let mut log = file("Log", &[TIMESTAMP], &fields);
            let levels = ["UNKNOWN", "DEBUG", "INFO", "WARNING", "ERROR", "FATAL"];
            let value = |(number, name): (i32, &str)| EnumValueDescriptorProto {
                name: Some(name.to_owned()),
                number: Some(number),
                options: None,
            };
            log.message_type[0].enum_type.push(EnumDescriptorProto {
                name: Some("Level".to_owned()),
                value: (0..).zip(levels).map(value).collect(),
                ..EnumDescriptorProto::default()
            });
            files.push(log);
        }
    }
    FileDescriptorSet { file: files }.encode_to_vec()
}

/// `foxglove/NAME.proto`, or for a name with a package that file: one message, its fields numbered from 1.
fn file(name: &str, imports: &[&str], fields: &[Field]) -> FileDescriptorProto {
    let (package, name) = name.rsplit_once('.').unwrap_or(("foxglove", name));
    let field = |(number, (name, kind, of)): (i32, &Field)| FieldDescriptorProto {
        name: Some((*name).to_owned()),
        number: Some(number),
        label: Some(Label::Optional.into()),
        r#type: Some((*kind).into()),
        type_name: (!of.is_empty()).then(|| format!(".{of}")),
        ..FieldDescriptorProto::default()
    };
    FileDescriptorProto {
        name: Some(path(package, name)),
        package: Some(package.to_owned()),
        dependency: imports
            .iter()
            .filter_map(|import| import.rsplit_once('.'))
            .map(|(package, name)| path(package, name))
            .collect(),
        message_type: vec![DescriptorProto {
            name: Some(name.to_owned()),
            field: (1..).zip(fields).map(field).collect(),
            ..DescriptorProto::default()
        }],
        syntax: Some("proto3".to_owned()),
        ..FileDescriptorProto::default()
    }
}

fn path(package: &str, name: &str) -> String {
    match package {
        "foxglove" => format!("foxglove/{name}.proto"),
        _ => format!("{}/{}.proto", package.replace('.', "/"), name.to_lowercase()),
    }
}

fn repeated(file: &mut FileDescriptorProto, name: &str) {
    let fields = file.message_type.iter_mut().flat_map(|message| &mut message.field);
    for field in fields.filter(|field| field.name.as_deref() == Some(name)) {
        field.label = Some(Label::Repeated.into());
    }
}
