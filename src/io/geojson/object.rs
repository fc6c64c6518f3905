//! Features and geometries.

use core::fmt;

use serde::de::{Deserialize, Deserializer, IgnoredAny, MapAccess, SeqAccess, Visitor};

use super::coordinates::{Coordinates, Kind, Whole};
use super::error::{Fault, Place};
use super::json::{Any, Label, Text, Value, skip_array, skip_object};
use super::scan::Scan;
use crate::geometry::{Feature, Shape};
use crate::io::MAX_NESTED_COLLECTIONS;

/// The members that GeoJSON gives a meaning; all others are foreign.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Key {
    Type,
    Features,
    Geometry,
    Properties,
    Id,
    Coordinates,
    Geometries,
    Foreign,
}

impl Key {
    fn name(self) -> &'static str {
        match self {
            Self::Type => "type",
            Self::Features => "features",
            Self::Geometry => "geometry",
            Self::Properties => "properties",
            Self::Id => "id",
            Self::Coordinates => "coordinates",
            Self::Geometries => "geometries",
            Self::Foreign => "",
        }
    }
}

impl<'de> Deserialize<'de> for Key {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct KeyVisitor;

        impl Visitor<'_> for KeyVisitor {
            type Value = Key;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the name of a member")
            }

            fn visit_str<E>(self, name: &str) -> Result<Key, E> {
                use Key::{Coordinates, Features, Foreign, Geometries, Geometry, Id, Properties, Type};
                let known = [Type, Features, Geometry, Properties, Id, Coordinates, Geometries];
                Ok(known.into_iter().find(|key| key.name() == name).unwrap_or(Foreign))
            }
        }

        deserializer.deserialize_identifier(KeyVisitor)
    }
}

/// The types of GeoJSON objects.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Type {
    FeatureCollection,
    Feature,
    GeometryCollection,
    Geometry(Kind),
}

impl Type {
    fn named(name: &str) -> Option<Self> {
        Some(match name {
            "FeatureCollection" => Self::FeatureCollection,
            "Feature" => Self::Feature,
            "GeometryCollection" => Self::GeometryCollection,
            "Point" => Self::Geometry(Kind::Point),
            "MultiPoint" => Self::Geometry(Kind::MultiPoint),
            "LineString" => Self::Geometry(Kind::Line),
            "MultiLineString" => Self::Geometry(Kind::MultiLine),
            "Polygon" => Self::Geometry(Kind::Polygon),
            "MultiPolygon" => Self::Geometry(Kind::MultiPolygon),
            _ => return None,
        })
    }
}

/// Where an object stands, which decides what it may be.
#[derive(Clone, Copy)]
pub(super) enum Role {
    /// Outermost: anything.
    Document,
    /// In the array `"features"`.
    Feature,
    /// In `"geometry"` or `"geometries"`, inside this many geometry collections.
    Geometry { depth: usize },
}

impl Role {
    fn allows(self, kind: Type) -> bool {
        match self {
            Self::Document => true,
            Self::Feature => kind == Type::Feature,
            Self::Geometry { .. } => matches!(kind, Type::GeometryCollection | Type::Geometry(_)),
        }
    }
}

/// An object, member by member, in whatever order they come.
pub(super) struct Object {
    role: Role,
    /// The place of its opening brace.
    at: Place,
    kind: Option<Type>,
    /// The members read, as a set of bits by [`Key`].
    seen: u8,
    /// What `"geometry"` draws.
    located: Vec<Shape>,
    /// What `"geometries"` draws.
    collected: Vec<Shape>,
    coordinates: Coordinates,
    id: Option<String>,
}

impl Object {
    pub(super) fn new(role: Role, at: Place) -> Self {
        Self {
            role,
            at,
            kind: None,
            seen: 0,
            located: Vec::new(),
            collected: Vec::new(),
            coordinates: Coordinates::default(),
            id: None,
        }
    }

    pub(super) fn kind(&self) -> Option<Type> {
        self.kind
    }

    /// Whether this member has been read.
    pub(super) fn has(&self, key: Key) -> bool {
        self.seen >> key as u8 & 1 == 1
    }

    /// Whether a member with this name can mean anything here, given what is known of the object's type so far.
    fn means(&self, key: Key) -> bool {
        let may_be = |kind: Type| self.role.allows(kind) && self.kind.is_none_or(|known| known == kind);
        match key {
            Key::Type => true,
            Key::Features => may_be(Type::FeatureCollection),
            Key::Geometry | Key::Properties | Key::Id => may_be(Type::Feature),
            Key::Geometries => may_be(Type::GeometryCollection),
            Key::Coordinates => match self.kind {
                None => self.role.allows(Type::Geometry(Kind::Point)),
                Some(known) => matches!(known, Type::Geometry(_)),
            },
            Key::Foreign => false,
        }
    }

    /// Decides whether to read the value of this member, and notes that it is there.
    pub(super) fn admit(&mut self, key: Key, scan: &mut Scan<'_>) -> bool {
        if !self.means(key) {
            return false;
        }
        if self.has(key) {
            scan.fail(scan.here(), Fault::Repeated { member: key.name() });
        }
        self.seen |= 1 << key as u8;
        if matches!((key, self.role), (Key::Geometry | Key::Coordinates | Key::Geometries, Role::Document)) {
            scan.enter_feature();
        }
        // After a fault only what helps to name the feature is still of interest.
        !scan.failed() || matches!(key, Key::Type | Key::Properties)
    }

    /// Reads or skips the value of a member other than `"features"`.
    pub(super) fn read<'de, A>(&mut self, key: Key, members: &mut A, scan: &mut Scan<'_>) -> Result<(), A::Error>
    where
        A: MapAccess<'de>,
    {
        if !self.admit(key, scan) {
            return members.next_value::<IgnoredAny>().map(drop);
        }
        let depth = match self.role {
            Role::Geometry { depth } => depth,
            Role::Document | Role::Feature => 0,
        };
        match key {
            Key::Type => {
                let found = members.next_value_seed(Any(Text))?;
                self.learn_type(found, scan);
                Ok(())
            }
            Key::Geometry => {
                let shapes = &mut self.located;
                members.next_value_seed(Any(Geometry { scan, shapes, depth, nullable: true }))
            }
            Key::Geometries => {
                let shapes = &mut self.collected;
                members.next_value_seed(Any(Geometries { scan, shapes, depth: depth + 1 }))
            }
            Key::Coordinates => members.next_value_seed(Any(Whole { scan, out: &mut self.coordinates })),
            Key::Properties => members.next_value_seed(Any(Properties { scan })),
            Key::Id => {
                self.id = members.next_value_seed(Any(Label))?;
                Ok(())
            }
            Key::Features | Key::Foreign => members.next_value::<IgnoredAny>().map(drop),
        }
    }

    fn learn_type(&mut self, found: Option<String>, scan: &mut Scan<'_>) {
        let Some(found) = found else {
            return scan.fail(scan.here(), Fault::NoType);
        };
        match Type::named(&found).filter(|&kind| self.role.allows(kind)) {
            Some(kind) => {
                self.kind = Some(kind);
                if kind != Type::FeatureCollection {
                    scan.enter_feature();
                }
            }
            None => scan.fail(scan.here(), Fault::Type { found: found.chars().take(40).collect() }),
        }
    }

    /// What the object draws, once all its members are read. Whatever it lacks is a fault.
    fn shapes(self, scan: &mut Scan<'_>) -> Vec<Shape> {
        let missing = |member: Key| (self.at, Fault::Missing { member: member.name() });
        let mut shapes = Vec::new();
        let outcome = match self.kind {
            _ if scan.failed() => Ok(()),
            None => Err((self.at, Fault::NoType)),
            Some(Type::FeatureCollection) if !self.has(Key::Features) => Err(missing(Key::Features)),
            Some(Type::FeatureCollection) => Ok(()),
            Some(Type::Feature) => {
                shapes = self.located;
                Ok(())
            }
            Some(Type::GeometryCollection) if !self.has(Key::Geometries) => Err(missing(Key::Geometries)),
            Some(Type::GeometryCollection) => {
                shapes = self.collected;
                Ok(())
            }
            Some(Type::Geometry(_)) if !self.has(Key::Coordinates) => Err(missing(Key::Coordinates)),
            Some(Type::Geometry(kind)) => self.coordinates.draw(kind, &mut shapes),
        };
        if let Err((at, fault)) = outcome {
            scan.fail(at, fault);
        }
        shapes
    }

    /// The feature that the object is, or that its geometry makes.
    pub(super) fn feature(mut self, scan: &mut Scan<'_>) -> Feature {
        let id = self.id.take();
        Feature { id, shapes: self.shapes(scan), name: None }
    }
}

/// One element of `"features"`.
pub(super) struct Member<'s, 'p> {
    pub(super) scan: &'s mut Scan<'p>,
}

impl Value for Member<'_, '_> {
    type Out = Feature;

    fn other(self) -> Feature {
        self.scan.fail(self.scan.here(), Fault::NotAnObject);
        Feature::default()
    }

    fn object<'de, A: MapAccess<'de>>(self, mut members: A) -> Result<Feature, A::Error> {
        let mut object = Object::new(Role::Feature, self.scan.here());
        while let Some(key) = members.next_key()? {
            object.read(key, &mut members, self.scan)?;
        }
        Ok(object.feature(self.scan))
    }
}

/// The value of `"geometry"`, or one element of `"geometries"`.
struct Geometry<'s, 'p> {
    scan: &'s mut Scan<'p>,
    shapes: &'s mut Vec<Shape>,
    /// How many geometry collections are around it.
    depth: usize,
    nullable: bool,
}

impl Value for Geometry<'_, '_> {
    type Out = ();

    fn other(self) {
        self.scan.fail(self.scan.here(), Fault::NotAnObject);
    }

    fn null(self) {
        if !self.nullable {
            self.other();
        }
    }

    fn object<'de, A: MapAccess<'de>>(self, mut members: A) -> Result<(), A::Error> {
        let Self { scan, shapes, depth, .. } = self;
        let at = scan.here();
        if depth > MAX_NESTED_COLLECTIONS {
            scan.fail(at, Fault::TooDeep);
        }
        // From here on `depth` is bounded, and with it the recursion.
        if scan.failed() {
            return skip_object(&mut members);
        }
        let mut object = Object::new(Role::Geometry { depth }, at);
        while let Some(key) = members.next_key()? {
            object.read(key, &mut members, scan)?;
        }
        shapes.append(&mut object.shapes(scan));
        Ok(())
    }
}

/// The value of `"geometries"`.
struct Geometries<'s, 'p> {
    scan: &'s mut Scan<'p>,
    shapes: &'s mut Vec<Shape>,
    depth: usize,
}

impl Value for Geometries<'_, '_> {
    type Out = ();

    fn other(self) {
        self.scan.fail(self.scan.here(), Fault::NotAnArray { member: "geometries" });
    }

    fn array<'de, A: SeqAccess<'de>>(self, mut array: A) -> Result<(), A::Error> {
        let Self { scan, shapes, depth } = self;
        loop {
            if scan.failed() {
                return skip_array(&mut array);
            }
            let element = Geometry { scan: &mut *scan, shapes: &mut *shapes, depth, nullable: false };
            if array.next_element_seed(Any(element))?.is_none() {
                return Ok(());
            }
        }
    }
}

/// The value of `"properties"`, of which only the name is kept.
struct Properties<'s, 'p> {
    scan: &'s mut Scan<'p>,
}

impl Value for Properties<'_, '_> {
    type Out = ();

    fn other(self) {}

    fn object<'de, A: MapAccess<'de>>(self, mut members: A) -> Result<(), A::Error> {
        while let Some(rank) = members.next_key_seed(Any(NameRank))? {
            match rank {
                Some(rank) => {
                    if let Some(name) = members.next_value_seed(Any(Label))? {
                        self.scan.propose_name(rank, name);
                    }
                }
                None => {
                    members.next_value::<IgnoredAny>()?;
                }
            }
        }
        Ok(())
    }
}

/// How good a property is as the name of its feature, 0 being the best.
struct NameRank;

impl Value for NameRank {
    type Out = Option<usize>;

    fn other(self) -> Option<usize> {
        None
    }

    fn text(self, key: &str) -> Option<usize> {
        ["name", "NAME", "Name", "ADMIN", "admin", "title", "id"].iter().position(|&name| name == key)
    }
}
