use super::*;
use crate::geometry::predicates::work_of;

#[test]
fn stats() {
    let mut builder = crate::geometry::Builder::new();
    crate::io::geojson::read(include_bytes!("../../../tests/data/world-50m.geojson").as_slice(), |feature| {
        builder.feature(&feature).unwrap();
        Ok::<(), crate::io::geojson::ReadError>(())
    })
    .unwrap();
    let map = builder.build().unwrap();
    let (locator, work) = work_of(|| Locator::new(&map).unwrap());
    let n = locator.rising.len() as f64;
    println!("build work {} per edge", work as f64 / n);
    println!("questions {} per edge", locator.graph.questions() as f64 / n);
    let mut state = 50_u64;
    let mut random = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        f64::from((state >> 33) as u32) / f64::from(1_u32 << 31)
    };
    let mut sums = [0_u64; 4];
    let mut hist = vec![0; 80];
    let mut lines = 0;
    for i in 0..100_000 {
        let p = Point::new(360.0 * random() - 180.0, 173.0 * random() - 90.0);
        let c = work_of(|| locator.locate(p)).1;
        hist[(c / 2) as usize] += 1;
        sums[0] += c;
        let v = map.point((random() * 75_000.0) as usize);
        let q = Point::new(v.x + 0.02 * random() - 0.01, v.y + 0.02 * random() - 0.01);
        sums[1] += work_of(|| locator.locate(q)).1;
        sums[3] += work_of(|| locator.graph.find(locator.graph.root(), q)).1;
        if i % 100 == 0 {
            lines += 1;
            sums[2] += work_of(|| locator.zone(&crate::geometry::Stretch::Segment(p, q))).1;
        }
    }
    println!("{hist:?}");
    println!(
        "anywhere {} near {} near from root {} line {}",
        sums[0] as f64 / 1e5,
        sums[1] as f64 / 1e5,
        sums[3] as f64 / 1e5,
        sums[2] as f64 / f64::from(lines)
    );
}
