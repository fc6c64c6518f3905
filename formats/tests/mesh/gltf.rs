//! glTF as text and binary.

use serde_json::{Value, json};
use twinedge_formats::mesh::{Cause, Format, MeshFile, Position, ReadError, read_bytes};

/// "A Minimal glTF File", of the tutorial of Khronos (github.com/KhronosGroup/glTF-Tutorials): one triangle, its indices 0 1 2 and its
/// places in one buffer.
fn minimal() -> Value {
    json!({
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0}]}],
        "buffers": [{
            "uri": "data:application/octet-stream;base64,AAABAAIAAAAAAAAAAAAAAAAAAAAAAIA/AAAAAAAAAAAAAAAAAACAPwAAAAA=",
            "byteLength": 44
        }],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 6, "target": 34963},
            {"buffer": 0, "byteOffset": 8, "byteLength": 36, "target": 34962}
        ],
        "accessors": [
            {"bufferView": 0, "byteOffset": 0, "componentType": 5123, "count": 3, "type": "SCALAR", "max": [2], "min": [0]},
            {"bufferView": 1, "byteOffset": 0, "componentType": 5126, "count": 3, "type": "VEC3", "max": [1, 1, 0], "min": [0, 0, 0]}
        ],
        "asset": {"version": "2.0"}
    })
}

fn read(document: &Value) -> Result<MeshFile, ReadError> {
    read_bytes(document.to_string().as_bytes(), Some(Format::Gltf))
}

fn faces(document: &Value) -> Vec<Vec<[f64; 3]>> {
    let mesh = read(document).unwrap().mesh;
    mesh.faces().map(|face| face.iter().map(|corner| mesh.points()[*corner as usize]).collect()).collect()
}

/// The document with the member at a pointer of JSON replaced.
fn with(pointer: &str, value: Value) -> Value {
    let mut document = minimal();
    let (parent, key) = pointer.rsplit_once('/').unwrap();
    let parent = document.pointer_mut(parent).unwrap();
    match key.parse::<usize>() {
        Ok(index) if parent.is_array() => parent[index] = value,
        _ => parent[key] = value,
    }
    document
}

/// A file in the binary form: a header, and chunks.
fn binary(document: &Value, data: &[u8]) -> Vec<u8> {
    let mut text = document.to_string().into_bytes();
    text.resize(text.len().next_multiple_of(4), b' ');
    let mut bytes = Vec::new();
    bytes.extend(b"glTF");
    for number in [2, (12 + 8 + text.len() + 8 + data.len()) as u32, text.len() as u32] {
        bytes.extend(number.to_le_bytes());
    }
    bytes.extend(b"JSON");
    bytes.extend(text);
    bytes.extend((data.len() as u32).to_le_bytes());
    bytes.extend(b"BIN\0");
    bytes.extend(data);
    bytes
}

#[test]
fn the_minimal_file_is_a_triangle_as_text_and_binary() {
    let expected = [[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]];
    assert_eq!(faces(&minimal()), expected);
    let mut data = vec![0, 0, 1, 0, 2, 0, 0, 0];
    data.extend([0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0].iter().flat_map(|x| x.to_le_bytes()));
    let mut document = minimal();
    document["buffers"] = json!([{"byteLength": 44}]);
    let file = read_bytes(&binary(&document, &data), None).unwrap();
    assert_eq!((file.format, file.mesh.face_count(), file.mesh.points().len()), (Format::Gltf, 1, 3));
    assert_eq!(Format::of_name("duck.GLB"), Some(Format::Gltf));
    assert_eq!(Format::of_name("duck.gltf"), Some(Format::Gltf));
}

#[test]
fn nodes_move_meshes_and_mirrors_keep_the_outside() {
    let node = |node: Value| faces(&with("/nodes/0", node));
    let moved = node(json!({"mesh": 0, "translation": [5, 0, 0], "scale": [2, 3, 4]}));
    assert_eq!(moved, [[[5.0, 0.0, 0.0], [7.0, 0.0, 0.0], [5.0, 3.0, 0.0]]]);
    // A quarter turn around z takes x to y, and y to −x.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let turned = node(json!({"mesh": 0, "rotation": [0, 0, half, half]}));
    for (found, expected) in turned[0].iter().zip([[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-15), "{turned:?}");
    }
    let mirrored = node(json!({"mesh": 0, "scale": [-1, 1, 1]}));
    assert_eq!(mirrored, [[[0.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]]]);
    let matrix = json!([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 7, 8, 9, 1]);
    assert_eq!(node(json!({"mesh": 0, "matrix": matrix}))[0].first(), Some(&[7.0, 8.0, 9.0]));
    // A mesh that is used by a node and by its child.
    let mut two = with(
        "/nodes",
        json!([{"mesh": 0, "children": [1], "translation": [1, 0, 0]}, {"mesh": 0, "translation": [0, 0, 2]}]),
    );
    assert_eq!(faces(&two).iter().map(|face| face[0]).collect::<Vec<_>>(), [[1.0, 0.0, 0.0], [1.0, 0.0, 2.0]]);
    two["scenes"] = json!([{"nodes": [1]}]);
    assert_eq!(faces(&two).len(), 1);
    // Without nodes, all meshes.
    two.as_object_mut().unwrap().retain(|key, _| !["scene", "scenes", "nodes"].contains(&&**key));
    assert_eq!(faces(&two), faces(&minimal()));
}

#[test]
fn strips_and_fans_are_triangles_wound_the_same_way() {
    // Four places of a square: 0 1 2 3 as a strip, with the indices in one byte each.
    let places = [0.0_f32, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
    let mut data: Vec<u8> = places.iter().flat_map(|x| x.to_le_bytes()).collect();
    data.extend([0, 1, 2, 3, 0, 1, 3, 2]);
    let mode = |mode: Option<u64>, at: usize| {
        let mut document = minimal();
        document["buffers"] = json!([{"byteLength": 56}]);
        document["bufferViews"] =
            json!([{"buffer": 0, "byteOffset": 48, "byteLength": 8}, {"buffer": 0, "byteLength": 48}]);
        document["accessors"] = json!([
            {"bufferView": 0, "byteOffset": at, "componentType": 5121, "count": 4, "type": "SCALAR"},
            {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"}
        ]);
        document["meshes"][0]["primitives"][0]["mode"] = json!(mode);
        let file = read_bytes(&binary(&document, &data), None).unwrap();
        (file.mesh.faces().map(<[u32]>::to_vec).collect::<Vec<_>>(), file.dropped)
    };
    assert_eq!(mode(Some(5), 0).0, [[0, 1, 2], [1, 3, 2]]);
    // Of the places 0 1 3 2 the triangles 1 3 0 and 3 2 0, by the order in which places occur.
    assert_eq!(mode(Some(6), 4).0, [[0, 1, 2], [1, 3, 2]]);
    assert_eq!(mode(None, 0).0, [[0, 1, 2]]);
    let (faces, dropped) = mode(Some(1), 0);
    assert_eq!((faces.len(), &*dropped[0].what), (0, "primitives of points and lines"));
}

#[test]
fn what_is_malformed_is_said() {
    let cause = |document: &Value| match read(document).unwrap_err() {
        ReadError::Content { format: Format::Gltf, position: Position::Line(1), cause } => cause,
        other => panic!("{other}"),
    };
    let text = |document: &Value| cause(document).to_string();
    assert!(text(&with("/accessors/1/count", json!(4))).contains("accessor 1: it leads beyond its buffer"));
    assert!(text(&with("/accessors/1/type", json!("VEC2"))).contains("its type is VEC2, not VEC3"));
    assert!(text(&with("/accessors/1/componentType", json!(1))).contains("the type of its components is unknown"));
    assert!(text(&with("/accessors/0/componentType", json!(5126))).contains("it leads beyond its buffer"));
    assert!(text(&with("/bufferViews/1/byteStride", json!(4))).contains("it leads beyond its buffer"));
    assert!(text(&with("/bufferViews/1/buffer", json!(9))).contains("it leads beyond its buffer"));
    assert!(text(&with("/accessors/1/bufferView", json!(9))).contains("it has no bytes"));
    assert!(text(&with("/meshes/0/primitives/0/indices", json!(9))).contains("accessor 9: there is none"));
    assert!(text(&with("/nodes/0", json!({"mesh": 3}))).contains("there is no mesh 3"));
    assert!(
        text(&with("/nodes/0", json!({"children": [0]}))).contains("node 0 has two parents, or is its own ancestor")
    );
    assert!(text(&with("/nodes/0", json!({"children": [5]}))).contains("there is no node 5"));
    assert!(text(&with("/scene", json!(5))).contains("there is no scene 5"));
    assert!(text(&with("/buffers/0", json!({"byteLength": 4}))).contains("buffer 0 has no bytes"));
    assert!(text(&with("/buffers/0", json!({"uri": "data:;base64,****"}))).contains("buffer 0: "));
    assert_eq!(
        cause(&with("/buffers/0", json!({"uri": "duck.bin"}))),
        Cause::Unsupported("a buffer in another file (as GLB it is in the same)")
    );
    assert_eq!(cause(&with("/accessors/0/sparse", json!({}))), Cause::Unsupported("a sparse accessor"));
    let draco = json!({"KHR_draco_mesh_compression": {}});
    assert_eq!(cause(&with("/meshes/0/primitives/0/extensions", draco)), Cause::Unsupported("compression by Draco"));
    let infinite = json!({"mesh": 0, "scale": [1e300, 1e300, 1e300], "children": [1]});
    let far = with("/nodes", json!([infinite, {"mesh": 0, "scale": [1e300, 1e300, 1e300]}]));
    assert!(matches!(cause(&far), Cause::NotFinite { .. }));
    let index = with("/accessors/1/count", json!(2));
    assert_eq!(cause(&index), Cause::IndexOutOfRange { index: 2, points: 2 });

    let error = |bytes: &[u8]| read_bytes(bytes, Some(Format::Gltf)).unwrap_err().to_string();
    assert!(error(b"glTF\x02\0\0\0\0\0\0\0").contains("expected the chunk JSON"));
    assert!(error(b"glTF").contains("expected the version"));
    assert!(error(b"glTF\x01\0\0\0\0\0\0\0").contains("a version of glTF other than 2"));
    let whole = binary(&minimal(), &[0; 44]);
    assert!(error(&whole[..whole.len() - 1]).contains("expected the chunk BIN"));
    assert!(error(b"{\n\"nodes\": 3}").contains("line 2"));
}

/// A mesh that many nodes use would otherwise fill the memory.
#[test]
fn a_mesh_that_is_used_too_often_is_refused() {
    let primitive = minimal()["meshes"][0]["primitives"][0].clone();
    let mut document = with("/meshes/0/primitives", Value::Array(vec![primitive; 2_000]));
    document["nodes"] = Value::Array(vec![json!({"mesh": 0}); 2_000]);
    document.as_object_mut().unwrap().retain(|key, _| !["scene", "scenes"].contains(&&**key));
    assert!(matches!(read(&document).unwrap_err(), ReadError::Content { cause: Cause::TooLarge, .. }));
    document["nodes"] = json!([{"mesh": 0}]);
    assert_eq!(read(&document).unwrap().mesh.face_count(), 2_000);
}

/// All places are moved for each node, also those that no index leads to.
#[test]
fn places_that_are_moved_too_often_are_refused() {
    const PLACES: usize = 5_000;
    let mut document = with("/accessors/1/count", PLACES.into());
    document["bufferViews"][1]["byteLength"] = (12 * PLACES).into();
    document["buffers"] = json!([{"byteLength": 8 + 12 * PLACES}]);
    let data = [vec![0, 0, 1, 0, 2, 0, 0, 0], vec![0; 12 * PLACES]].concat();
    let read = |nodes: usize| {
        let mut document = document.clone();
        document["nodes"] = Value::Array(vec![json!({"mesh": 0}); nodes]);
        document["scenes"][0]["nodes"] = (0..nodes).collect();
        read_bytes(&binary(&document, &data), None)
    };
    assert_eq!(read(10).unwrap().mesh.face_count(), 10);
    assert!(matches!(read(2_000).unwrap_err(), ReadError::Content { cause: Cause::TooLarge, .. }));
}
