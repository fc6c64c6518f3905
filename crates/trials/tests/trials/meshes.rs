//! `meshes`.

use twinedge::dcel::Dcel;
use twinedge::validate::Expectation;
use twinedge_trials::RawPointers;
use twinedge_trials::meshes::{MeshStructure, MeshesResults, MeshesWork, Shape};
use twinedge_trials::planted::Planted;
use twinedge_trials::{Outcome, Run, Shard, Structure, meshes, sum};

#[allow(dead_code, unreachable_pub, reason = "an example has a main function of its own")]
#[path = "../../../../examples/mesh_conformance.rs"]
mod mesh;
use mesh::{MESH, Mesh};

fn of(outcome: &Outcome<MeshesResults>, name: &str) -> u64 {
    outcome.operators.iter().find(|row| row.operator == name).unwrap().applied
}

#[test]
fn a_mesh_does_what_the_steps_do_on_every_small_triangulation() {
    let mine = MeshStructure::new("mine", |map| Mesh::new(map.vertices, &map.triangles, false), MESH);
    let outcome = meshes(&mine, MeshesWork { vertices: 6 }, &Run::default()).into_result().unwrap();
    let spheres = outcome.rows.iter().filter(|row| matches!(row.shape, Shape::Sphere { .. }));
    // OEIS A000109 and A000260.
    let counts: Vec<_> = spheres.map(|row| (row.unrooted, row.rooted)).collect();
    assert_eq!(counts, [(1, 1), (1, 1), (1, 3), (2, 13)]);
    for name in ["mesh_flip_edge", "mesh_split_edge", "mesh_collapse_edge"] {
        assert!(of(&outcome, name) > 50, "{outcome:?}");
    }
    assert_eq!(of(&outcome, "mesh_split_face") + of(&outcome, "flip_edge"), 0);
}

#[test]
fn a_wrong_flip_is_found_on_the_smallest_triangulation_that_shows_it() {
    let wrong = MeshStructure::new("wrong", |map| Mesh::new(map.vertices, &map.triangles, true), MESH);
    // Two triangles back to back: both have the same third vertex.
    let outcome = meshes(&wrong, MeshesWork { vertices: 3 }, &Run::default());
    let finding = &outcome.findings[0];
    assert!(finding.operator.as_ref().unwrap().starts_with("mesh_flip_edge"), "{finding}");
    assert!(finding.message.contains("not be simple"), "{finding}");
    assert!(!outcome.is_ok());
}

#[test]
fn structures_of_planar_maps_do_the_same_on_discs() {
    let work = MeshesWork { vertices: 4 };
    let slots = MeshStructure::plane(Structure::new("map", Dcel::new, Expectation::plane()));
    let model = MeshStructure::plane(Structure::new("map", RawPointers::new, Expectation::plane()));
    let outcome = meshes(&slots, work, &Run::default()).into_result().unwrap();
    assert_eq!(meshes(&model, work, &Run::default()), outcome);
    // A triangle; a triangle with a vertex inside; a square with either diagonal (Brown 1964).
    assert_eq!(outcome.rows.iter().map(|row| row.rooted).collect::<Vec<_>>(), [1, 1, 2]);
    let names = ["mesh_flip_edge", "mesh_split_edge", "mesh_split_face", "mesh_collapse_edge", "connect", "flip_edge"];
    assert!(names.into_iter().all(|name| of(&outcome, name) > 0), "{outcome:?}");
    // In parts, the outcome is the same.
    let part = |index| meshes(&slots, work, &Run::default().shard(Shard::new(index, 2).unwrap()));
    assert_eq!(sum(&[part(0), part(1)]), Ok(outcome));
    // It is also equal with missing operators, and with more threads.
    let mine = MeshStructure::new("mine", |map| Mesh::new(map.vertices, &map.triangles, false), MESH);
    let part = |index| meshes(&mine, work, &Run::default().shard(Shard::new(index, 3).unwrap()));
    let whole = meshes(&mine, work, &Run::default().threads(1));
    assert!(whole.operators.iter().any(|row| row.not_supported > 0), "{whole:?}");
    assert_eq!(sum(&[part(0), part(1), part(2)]).as_ref(), Ok(&whole));
    assert_eq!(meshes(&mine, work, &Run::default().threads(3)), whole);
    // An edge that turns the wrong way.
    let planted = MeshStructure::plane(Structure::new("planted", Planted::<false>::default, Expectation::plane()));
    let finding = meshes(&planted, work, &Run::default()).findings.remove(0);
    assert!(finding.operator.as_ref().is_some_and(|op| op.starts_with("flip_edge")), "{finding}");
}
