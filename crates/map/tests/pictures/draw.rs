//! Scenes as SVG for a page of text: without style sheet, in the colour of the text with transparent fills, readable on light and
//! dark.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use twinedge::dcel::{Face, FaceKey, HalfEdge, HalfEdgeKey, VertexKey};

use crate::scene::{Place, Scene};

/// The role of an element in the operator.
#[derive(Clone, Copy)]
pub(crate) enum Role {
    Given,
    Made,
    Dropped,
}

impl Role {
    const ALL: [(Self, &'static str); 3] = [(Self::Given, "given"), (Self::Made, "made"), (Self::Dropped, "dropped")];

    const fn colour(self) -> &'static str {
        match self {
            Self::Given => "#d97706",
            Self::Made => "#2f81f7",
            Self::Dropped => "#e5484d",
        }
    }
}

/// A mark in a scene.
#[derive(Clone)]
pub(crate) enum Mark {
    /// A half-edge as an arrow, with its name.
    HalfEdge(HalfEdgeKey, &'static str, Role),
    /// An edge without a direction.
    Edge(HalfEdgeKey, Role),
    /// The corner of a half-edge.
    Corner(HalfEdgeKey, &'static str),
    Vertex(VertexKey, &'static str, Role),
    /// The name of a face, and its position.
    Face(FaceKey, &'static str, Place),
}

/// A row of a picture: before and after.
pub(crate) struct Row {
    pub before: (Scene, Vec<Mark>),
    pub after: (Scene, Vec<Mark>),
}

const PANEL: Place = [150.0, 110.0];
const GAP: f64 = 50.0;
const LEGEND: f64 = 18.0;
const FILLS: [&str; 3] = ["#2da44e", "#a371f7", "#8b949e"];

/// The picture of these rows, one below the other.
pub(crate) fn picture(title: &str, rows: &[Row]) -> String {
    let [width, height] = [2.0 * PANEL[0] + GAP, PANEL[1] * rows.len() as f64 + LEGEND];
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" \
         role=\"img\" aria-label=\"{title}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.3\" \
         stroke-linejoin=\"round\" stroke-linecap=\"round\" font-family=\"sans-serif\" font-size=\"12\" \
         text-anchor=\"middle\" style=\"max-width:100%\">\n"
    );
    for (row, y) in rows.iter().zip((0..).map(|row| f64::from(row) * PANEL[1])) {
        let mut fills = Fills::default();
        Panel { out: &mut out, scene: &row.before.0, origin: [0.0, y] }.draw(&row.before.1, &mut fills);
        let [x, y_middle] = [PANEL[0] + GAP / 2.0, y + PANEL[1] / 2.0];
        line(&mut out, &[[x - 14.0, y_middle], [x + 12.0, y_middle]], "stroke-width=\"1.5\"");
        head(&mut out, [x + 15.0, y_middle], [1.0, 0.0], "currentColor");
        let origin = [PANEL[0] + GAP, y];
        Panel { out: &mut out, scene: &row.after.0, origin }.draw(&row.after.1, &mut fills);
    }
    for ((role, name), x) in Role::ALL.into_iter().zip([-60.0, 0.0, 60.0]) {
        text(&mut out, [width / 2.0 + x, height - 5.0], name, role.colour());
    }
    out.push_str("</svg>\n");
    out
}

/// A colour for each bounded face, equal before and after.
#[derive(Default)]
struct Fills(BTreeMap<FaceKey, &'static str>);

impl Fills {
    fn of(&mut self, face: FaceKey) -> &'static str {
        let next = FILLS[self.0.len() % FILLS.len()];
        self.0.entry(face).or_insert(next)
    }
}

struct Panel<'a> {
    out: &'a mut String,
    scene: &'a Scene,
    origin: Place,
}

impl Panel<'_> {
    fn at(&self, [x, y]: Place) -> Place {
        [self.origin[0] + x, self.origin[1] + PANEL[1] - y]
    }

    fn ends(&self, h: HalfEdge<'_>) -> [Place; 2] {
        [h.origin(), h.target()].map(|v| self.at(self.scene.place(v)))
    }

    fn draw(&mut self, marks: &[Mark], fills: &mut Fills) {
        let scene = self.scene;
        for face in scene.dcel.faces().filter(|face| !face.is_unbounded()) {
            self.face(face, fills.of(face.key()));
        }
        for edge in scene.dcel.edges() {
            let ends = self.ends(edge);
            line(self.out, &ends, "");
        }
        for vertex in scene.dcel.vertices() {
            let at = self.at(scene.place(vertex));
            circle(self.out, at, 2.6, "currentColor");
        }
        for mark in marks {
            self.mark(mark, fills);
        }
    }

    fn face(&mut self, face: Face<'_>, colour: &str) {
        let mut outline = String::new();
        for boundary in face.boundaries().filter(|boundary| boundary.start().is_some()) {
            for (h, command) in boundary.half_edges().zip(std::iter::once('M').chain(std::iter::repeat('L'))) {
                let [x, y] = self.at(self.scene.place(h.origin()));
                let _ = write!(outline, "{command}{x:.1} {y:.1}");
            }
            outline.push('Z');
        }
        let _ = writeln!(
            self.out,
            "<path stroke=\"none\" fill=\"{colour}\" fill-opacity=\".2\" fill-rule=\"evenodd\" d=\"{outline}\"></path>"
        );
    }

    fn mark(&mut self, mark: &Mark, fills: &mut Fills) {
        let dcel = &self.scene.dcel;
        match *mark {
            Mark::HalfEdge(key, name, role) => {
                let [a, b] = self.ends(dcel.half_edge(key).expect("it is live"));
                let (along, left) = directions(a, b);
                let tail = moved(moved(a, along, 9.0), left, 4.5);
                let tip = moved(moved(b, along, -9.0), left, 4.5);
                line(
                    self.out,
                    &[tail, moved(tip, along, -3.0)],
                    &format!("stroke=\"{}\" stroke-width=\"1.8\"", role.colour()),
                );
                head(self.out, tip, along, role.colour());
                let middle = [f64::midpoint(tail[0], tip[0]), f64::midpoint(tail[1], tip[1]) + 4.0];
                text(self.out, moved(middle, left, 9.0), name, role.colour());
            }
            Mark::Edge(key, role) => {
                let ends = self.ends(dcel.half_edge(key).expect("it is live"));
                line(self.out, &ends, &format!("stroke=\"{}\" stroke-width=\"2.4\"", role.colour()));
            }
            Mark::Corner(key, name) => {
                let h = dcel.half_edge(key).expect("it is live");
                let direction = self.scene.corner_direction(h);
                let at = self.at(self.scene.place(h.origin()));
                let towards = [direction.cos(), -direction.sin()];
                circle(self.out, moved(at, towards, 7.0), 2.2, Role::Given.colour());
                let [x, y] = moved(at, towards, 16.0);
                text(self.out, [x, y + 4.0], name, Role::Given.colour());
            }
            Mark::Vertex(key, name, role) => {
                let at = self.at(self.scene.place(dcel.vertex(key).expect("it is live")));
                circle(self.out, at, 4.0, role.colour());
                text(self.out, [at[0], at[1] - 8.0], name, role.colour());
            }
            Mark::Face(key, name, place) => {
                let [x, y] = self.at(place);
                text(self.out, [x, y + 4.0], name, fills.of(key));
            }
        }
    }
}

/// The direction from one point to another in pixels, and the one to its left.
fn directions(a: Place, b: Place) -> (Place, Place) {
    let length = (b[0] - a[0]).hypot(b[1] - a[1]);
    let along = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
    (along, [along[1], -along[0]])
}

fn moved(from: Place, direction: Place, distance: f64) -> Place {
    [from[0] + direction[0] * distance, from[1] + direction[1] * distance]
}

fn line(out: &mut String, points: &[Place], attributes: &str) {
    let [a, b] = [points[0], points[1]];
    let space = if attributes.is_empty() { "" } else { " " };
    let _ = writeln!(out, "<path{space}{attributes} d=\"M{:.1} {:.1}L{:.1} {:.1}\"></path>", a[0], a[1], b[0], b[1]);
}

/// The head of an arrow with this tip.
fn head(out: &mut String, tip: Place, along: Place, colour: &str) {
    let left = [along[1], -along[0]];
    let back = moved(tip, along, -7.0);
    let [a, b] = [moved(back, left, 3.5), moved(back, left, -3.5)];
    let _ = writeln!(
        out,
        "<path stroke=\"none\" fill=\"{colour}\" d=\"M{:.1} {:.1}L{:.1} {:.1}L{:.1} {:.1}Z\"></path>",
        tip[0], tip[1], a[0], a[1], b[0], b[1]
    );
}

fn circle(out: &mut String, [x, y]: Place, radius: f64, colour: &str) {
    let _ =
        writeln!(out, "<circle stroke=\"none\" fill=\"{colour}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\"></circle>");
}

fn text(out: &mut String, [x, y]: Place, what: &str, colour: &str) {
    let _ = writeln!(out, "<text stroke=\"none\" fill=\"{colour}\" x=\"{x:.1}\" y=\"{y:.1}\">{what}</text>");
}
