//! Attributes of unique tokens: policies must neither lose nor duplicate one.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use twinedge::dcel::{Attribute, Attributed, Corners, Dcel, Edges, Faces, HalfEdges, Policy, Vertices};

pub(crate) type Tokens = Vec<u64>;

/// The tokens made and dropped for one kind of record.
#[derive(Clone, Debug, Default)]
pub(crate) struct Mint {
    made: Arc<AtomicU64>,
    dropped: Arc<Mutex<Tokens>>,
}

/// One for vertices, half-edges, edges, corners and faces.
pub(crate) type Mints = [Mint; 5];

impl Mint {
    fn token(&self) -> u64 {
        self.made.fetch_add(1, Ordering::Relaxed)
    }

    /// Parts share tokens, merged records join them, and new records get a new one. If `refuses` is not 0, every
    /// `refuses`-th token is refused.
    pub(crate) fn policy<K: Attributed>(&self, policy: Policy<K, Tokens>, refuses: u64) -> Policy<K, Tokens> {
        let (mint, drain) = (self.clone(), self.clone());
        let refuse = move |tokens: &Tokens| {
            let refused = refuses > 0 && tokens.iter().any(|token| token % refuses == 3);
            if refused { Err("not this token") } else { Ok(()) }
        };
        policy
            .make_with(move || vec![mint.token()])
            .split_with(move |mut tokens| {
                refuse(&tokens)?;
                let other = tokens.split_off(tokens.len() / 2);
                Ok([Some(tokens), Some(other)])
            })
            .merge_with(move |kept, dropped| {
                let all = kept.into_iter().chain(dropped).flatten().collect();
                refuse(&all).map(|()| Some(all))
            })
            .drop_with(move |tokens| {
                refuse(tokens)?;
                drain.dropped.lock().unwrap().extend(tokens);
                Ok(())
            })
    }
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Handles {
    pub(crate) vertices: Attribute<Vertices, Tokens>,
    pub(crate) half_edges: Attribute<HalfEdges, Tokens>,
    pub(crate) edges: Attribute<Edges, Tokens>,
    pub(crate) corners: Attribute<Corners, Tokens>,
    pub(crate) faces: Attribute<Faces, Tokens>,
}

/// All values, by kind and key.
pub(crate) type Values = [BTreeMap<String, Tokens>; 5];

/// Attributes of a structure or a map.
macro_rules! handles {
    ($host:expr, $mints:expr, $refuses:expr) => {{
        let [vertices, half_edges, edges, corners, faces] = $mints;
        $crate::support::tokens::Handles {
            vertices: $host.add_attribute(vertices.policy(twinedge::dcel::Policy::of_vertices(), $refuses)),
            half_edges: $host.add_attribute(half_edges.policy(twinedge::dcel::Policy::of_half_edges(), $refuses)),
            edges: $host.add_attribute(edges.policy(twinedge::dcel::Policy::of_edges(), $refuses)),
            corners: $host.add_attribute(corners.policy(twinedge::dcel::Policy::of_corners(), $refuses)),
            faces: $host.add_attribute(faces.policy(twinedge::dcel::Policy::of_faces(), $refuses)),
        }
    }};
}

pub(crate) use handles;

impl Handles {
    /// Attributes of the empty structure.
    pub(crate) fn new(dcel: &mut Dcel, mints: &Mints, refuses: u64) -> Self {
        let handles = handles!(dcel, mints, refuses);
        dcel.set_value(handles.faces, dcel.unbounded_face().key(), mints[4].purse()).unwrap();
        handles
    }

    pub(crate) fn values(self, dcel: &Dcel) -> Values {
        fn all<K: Attributed>(dcel: &Dcel, of: Attribute<K, Tokens>) -> BTreeMap<String, Tokens>
        where
            K::Key: Debug,
        {
            let values = dcel.values(of).unwrap().iter();
            values.map(|(key, tokens)| (format!("{key:?}"), tokens.clone())).collect()
        }
        [
            all(dcel, self.vertices),
            all(dcel, self.half_edges),
            all(dcel, self.edges),
            all(dcel, self.corners),
            all(dcel, self.faces),
        ]
    }

    /// Checks that exactly the records have values, and that no token is lost or duplicated.
    pub(crate) fn check(self, dcel: &Dcel, mints: &Mints) {
        let values = self.values(dcel);
        let edges = dcel.edge_count();
        let counts = [dcel.vertex_count(), 2 * edges, edges, 2 * edges, dcel.face_count()];
        assert_eq!(values.each_ref().map(BTreeMap::len), counts);
        assert!(dcel.vertices().all(|v| dcel.value(self.vertices, v.key()).is_some()));
        assert!(dcel.faces().all(|f| dcel.value(self.faces, f.key()).is_some()));
        for h in dcel.half_edges() {
            assert!(dcel.value(self.half_edges, h.key()).is_some());
            assert!(dcel.value(self.corners, h.key()).is_some());
            assert_eq!(dcel.value(self.edges, h.key()), dcel.value(self.edges, h.twin().key()));
        }
        for (values, mint) in values.iter().zip(mints) {
            mint.check(values.values().flatten().copied().collect());
        }
    }
}

impl Mint {
    /// Returns the numbers of tokens made and dropped.
    pub(crate) fn counts(&self) -> [usize; 2] {
        [self.made.load(Ordering::Relaxed) as usize, self.dropped.lock().unwrap().len()]
    }

    /// Checks that these are all tokens made and not dropped, each once.
    pub(crate) fn check(&self, mut tokens: Tokens) {
        tokens.extend(self.dropped.lock().unwrap().iter());
        tokens.sort_unstable();
        assert!(tokens.into_iter().eq(0..self.made.load(Ordering::Relaxed)));
    }

    pub(crate) fn has_dropped(&self, token: u64) -> bool {
        self.dropped.lock().unwrap().contains(&token)
    }

    /// Enough tokens for faces to share.
    pub(crate) fn purse(&self) -> Tokens {
        (0..40).map(|_| self.token()).collect()
    }
}
