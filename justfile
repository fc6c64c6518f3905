# Recipes of one line; `just --list` shows them.

# The checks for people at work
quick:
    .ci/quick

# Everything that guards a landing
run:
    .ci/run

# Hours
nightly:
    .ci/nightly

# A benchmark, such as `just bench validation`
bench name:
    cargo bench -p twinedge-benches --bench {{name}}

# Plants the faults whose names or files contain the words, until two checks have caught each
faults words:
    cargo run -p twinedge-proofs --example faults -- --enough 2 --only {{words}}

# Runs a fuzz target
fuzz target runs="1000000":
    fuzz/run.sh {{runs}} {{target}}
