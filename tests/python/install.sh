#!/bin/sh
# Usage: install.sh PYTHON SOURCE BUILD WORK
# Installs the package with pip into an environment of its own, as a user would, and plays a shot with
# what is there. What is compiled is taken from BUILD, so that it is not compiled once more.
set -eu
python=$1 source=$2 build=$3 work=$4

rm -rf "$work/environment" "$work/copy"
"$python" -m venv --system-site-packages "$work/environment"
# A copy: building leaves files beside the sources.
mkdir "$work/copy"
(cd "$source" && tar -cf - --exclude=./build* --exclude=./.git .) | tar -xf - -C "$work/copy"
OSCULO_BUILD_DIR=$build "$work/environment/bin/python" -m pip install --quiet --no-index \
  --no-build-isolation --no-deps "$work/copy"
cd "$work"
"$work/environment/bin/python" -c '
import osculo, sys
assert osculo.__file__.startswith(sys.prefix), osculo.__file__
run = osculo.simulate(osculo.preset("break"))
assert run.status == "at_rest", run
print(run)'
