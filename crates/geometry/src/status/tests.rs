//! Tests of `status`.

use super::*;

fn level(height: u32) -> Strand {
    let [low, high] = [0.0, 2.0].map(|x| Point::new(x, height.into()));
    Strand { low, high, segment: height, end: 0, companion: NIL }
}

fn beside(height: f64) -> Point {
    Point::new(1.0, height)
}

/// Returns the handles from the bottom up in the tree. Checks that it has valid parents and priorities, and agrees with the list.
fn in_order(status: &Status) -> Vec<u32> {
    let node = |handle: u32| &status.nodes[handle as usize];
    let (mut order, mut path, mut next) = (Vec::new(), Vec::new(), status.root);
    loop {
        while next != NIL {
            for child in [node(next).left, node(next).right] {
                assert!(child == NIL || node(child).parent == next && priority(child) < priority(next));
            }
            path.push(next);
            next = node(next).left;
        }
        let Some(handle) = path.pop() else { break };
        order.push(handle);
        next = node(handle).right;
    }
    assert!(status.root == NIL || node(status.root).parent == NIL);
    for pair in order.windows(2) {
        assert_eq!((status.above(pair[0]), status.below(pair[1])), (pair[1], pair[0]));
    }
    assert!(order.first().is_none_or(|&lowest| status.below(lowest) == NIL));
    assert!(order.last().is_none_or(|&highest| status.above(highest) == NIL));
    order
}

#[test]
fn keeps_the_order_of_a_sorted_vector() {
    let (mut status, mut model) = (Status::new(), Vec::<(u32, u32)>::new());
    let (mut random, mut most) = (1_u32, 0);
    for _ in 0..3000 {
        // Insert an absent height, remove a present one.
        random = random.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let height = (random >> 16) % 509;
        match model.binary_search_by_key(&height, |&(height, _)| height) {
            Ok(i) => {
                let (gap, on) = status.locate(beside(height.into()));
                assert_eq!((gap.below, on), (model[i].1, model[i].1));
                status.remove(model.remove(i).1);
            }
            Err(i) => {
                let (gap, on) = status.locate(beside(height.into()));
                let neighbour = |i: usize| model.get(i).map_or(NIL, |&(_, handle)| handle);
                assert_eq!((gap.below, gap.above, on), (neighbour(i.wrapping_sub(1)), neighbour(i), NIL));
                model.insert(i, (height, status.insert(gap, level(height))));
            }
        }
        most = most.max(model.len());
        let (order, expected) = (in_order(&status), model.iter().map(|&(_, handle)| handle));
        assert!(order.into_iter().eq(expected));
        for &(height, handle) in &model {
            assert_eq!(status.strand(handle).segment, height);
        }
    }
    assert_eq!(status.nodes.len(), most, "nodes are used again");
}

#[test]
fn stays_shallow() {
    const N: u32 = 1 << 16;
    let rising = (0..N).collect();
    let falling = (0..N).rev().collect();
    let inwards = (0..N).map(|i| if i % 2 == 0 { i / 2 } else { N - 1 - i / 2 }).collect();
    let outwards = (0..N).rev().map(|i| if i % 2 == 0 { i / 2 } else { N - 1 - i / 2 }).collect();
    let mixed = (0..N).map(|i| i * 7919 % N).collect();
    let orders: [Vec<u32>; 5] = [rising, falling, inwards, outwards, mixed];
    for order in orders {
        let mut status = Status::new();
        for height in order {
            let (gap, _) = status.locate(beside(height.into()));
            status.insert(gap, level(height));
        }
        let depth = |mut handle: u32| {
            let mut depth = 0;
            while handle != NIL {
                depth += 1;
                handle = status.nodes[handle as usize].parent;
            }
            depth
        };
        let depths: Vec<u32> = in_order(&status).into_iter().map(depth).collect();
        let deepest = *depths.iter().max().unwrap();
        let mean = f64::from(depths.iter().sum::<u32>()) / f64::from(N);
        // A random search tree has a mean of 2 ln n - 3 or so, here 20, and hardly ever a depth beyond 4.3 ln n, here 48.
        assert!(deepest <= 48 && mean <= 24.0, "depth {deepest}, mean {mean}");
    }
}
