//! A writer of small, uncompressed OpenStreetMap files.

use tempfile::NamedTempFile;

pub(crate) type Members = Vec<(i64, &'static str)>;

/// The elements of a file.
pub(crate) struct File {
    pub(crate) nodes: Vec<(i64, i64, i64)>,
    pub(crate) ways: Vec<(i64, Vec<i64>)>,
    /// The id, level, name and members of each relation.
    pub(crate) relations: Vec<(i64, &'static str, &'static str, Members)>,
    /// The tag `type` of all relations.
    pub(crate) type_of_relations: &'static str,
    /// A feature required of readers.
    pub(crate) needs: Option<&'static str>,
    /// The type of members; 1 for ways.
    pub(crate) type_of_members: u64,
}

impl Default for File {
    fn default() -> Self {
        Self {
            nodes: Vec::new(),
            ways: Vec::new(),
            relations: Vec::new(),
            type_of_relations: "boundary",
            needs: None,
            type_of_members: 1,
        }
    }
}

impl File {
    /// Adds a node at whole degrees.
    pub(crate) fn node(&mut self, id: i64, x: i64, y: i64) {
        self.nodes.push((id, x, y));
    }

    pub(crate) fn way(&mut self, id: i64, nodes: &[i64]) {
        self.ways.push((id, nodes.to_vec()));
    }

    pub(crate) fn relation(
        &mut self,
        id: i64,
        level: &'static str,
        name: &'static str,
        members: &[(i64, &'static str)],
    ) {
        self.relations.push((id, level, name, members.to_vec()));
    }

    pub(crate) fn written(&self) -> NamedTempFile {
        let file = NamedTempFile::new().unwrap();
        std::fs::write(file.path(), self.bytes()).unwrap();
        file
    }

    pub(crate) fn bytes(&self) -> Vec<u8> {
        let mut header = Message::default();
        for feature in ["OsmSchema-V0.6", "DenseNodes"].into_iter().chain(self.needs) {
            header.bytes(4, feature.as_bytes());
        }
        let mut strings = vec![String::new()];
        let mut string = |text: &str| {
            let known = strings.iter().position(|known| known == text);
            known.unwrap_or_else(|| {
                strings.push(text.to_owned());
                strings.len() - 1
            }) as u64
        };
        let mut group = Message::default();
        for (id, x, y) in &self.nodes {
            let mut node = Message::default();
            node.number(1, zigzag(*id));
            // In units of 100 nanodegrees.
            node.number(8, zigzag(y * 10_000_000));
            node.number(9, zigzag(x * 10_000_000));
            group.bytes(1, &node.0);
        }
        for (id, nodes) in &self.ways {
            let mut way = Message::default();
            way.number(1, id.cast_unsigned());
            way.packed(8, differences(nodes.iter().copied()));
            group.bytes(3, &way.0);
        }
        for (id, level, name, members) in &self.relations {
            let tags = [("type", self.type_of_relations), ("admin_level", level), ("name", name)];
            let mut relation = Message::default();
            relation.number(1, id.cast_unsigned());
            relation.packed(2, tags.iter().map(|(key, _)| string(key)));
            relation.packed(3, tags.iter().map(|(_, value)| string(value)));
            relation.packed(8, members.iter().map(|(_, role)| string(role)));
            relation.packed(9, differences(members.iter().map(|(way, _)| *way)));
            relation.packed(10, members.iter().map(|_| self.type_of_members));
            group.bytes(4, &relation.0);
        }
        let mut table = Message::default();
        for text in &strings {
            table.bytes(1, text.as_bytes());
        }
        let mut block = Message::default();
        block.bytes(1, &table.0);
        block.bytes(2, &group.0);
        [blob("OSMHeader", &header), blob("OSMData", &block)].concat()
    }
}

/// A block with its length and its header.
fn blob(kind: &str, content: &Message) -> Vec<u8> {
    let mut blob = Message::default();
    blob.bytes(1, &content.0);
    let mut header = Message::default();
    header.bytes(1, kind.as_bytes());
    header.number(3, blob.0.len() as u64);
    let length = u32::try_from(header.0.len()).unwrap().to_be_bytes();
    [&length[..], &header.0, &blob.0].concat()
}

fn zigzag(number: i64) -> u64 {
    ((number << 1) ^ (number >> 63)).cast_unsigned()
}

fn differences(numbers: impl Iterator<Item = i64>) -> impl Iterator<Item = u64> {
    let mut before = 0;
    numbers.map(move |number| zigzag(number - std::mem::replace(&mut before, number)))
}

#[derive(Default)]
struct Message(Vec<u8>);

impl Message {
    fn varint(&mut self, mut number: u64) {
        while number > 0x7f {
            self.0.push(number as u8 | 0x80);
            number >>= 7;
        }
        self.0.push(number as u8);
    }

    fn number(&mut self, field: u64, number: u64) {
        self.varint(field << 3);
        self.varint(number);
    }

    fn bytes(&mut self, field: u64, bytes: &[u8]) {
        self.varint(field << 3 | 2);
        self.varint(bytes.len() as u64);
        self.0.extend_from_slice(bytes);
    }

    fn packed(&mut self, field: u64, numbers: impl Iterator<Item = u64>) {
        let mut all = Self::default();
        numbers.for_each(|number| all.varint(number));
        self.bytes(field, &all.0);
    }
}
