#!/bin/bash -eu
exec "$SRC/twinedge/fuzz/oss-fuzz/build.sh"
