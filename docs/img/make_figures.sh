#!/usr/bin/env bash
# make_figures.sh [BUILD]: draws every picture of the documentation again, with the program and the libraries of a
# build folder (default: build/release). Run it after a change of the pictures and look at what git says.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=${1:-build/release}
out=docs/img

draw() {  # draw FILE COMMAND...: tautline COMMAND with the picture in FILE; exit status 3 has a picture, too
  local file=$out/$1 status=0
  shift
  "$build/apps/cli/tautline" "$@" --quiet "--${file##*.}" "$file" || status=$?
  ((status == 0 || status == 3))
}

draw willow_demo.png plan scenes/willow_demo.yaml
draw plan.svg plan scenes/store_room.yaml
draw plan_crossing_free.svg plan scenes/loop.yaml --crossing-free
draw contact_free.svg plan scenes/contact_free/complex_4_deployed.yaml --contact-free
"$build/apps/cli/tautline" plan scenes/contact_free/complex_4_deployed.yaml --contact-free --quiet \
  --animate $out/contact_free_film.svg
draw field.svg plan scenes/store_room.yaml --field --resolution 0.35 --field-classes 2
draw classes.svg classes scenes/tanks.yaml --count 6
draw reach.svg reach scenes/store_room.yaml --sheets
draw reach_plane.svg reach scenes/two_ways.yaml
draw taut.svg taut scenes/tanks.yaml
draw show.svg show scenes/free_ground.yaml
draw workspace.svg workspace boundary scenes/camera_hall.yaml
draw workspace_futures.svg workspace boundary scenes/workspace.yaml
draw workspace_best.svg workspace best scenes/workspace.yaml
draw workspace_pose.svg workspace pose scenes/workspace.yaml --at 90,90
draw workspace_move.svg workspace move scenes/camera_hall.yaml --from 30,10 --to 110,100 --speed 10 --acceleration 4 \
  --winch-limit 6
draw workspace_tour.svg workspace tour scenes/camera_hall.yaml --round
draw fleet.svg fleet check scenes/fleet.yaml
draw fleet_layouts.svg fleet layouts scenes/fleet_yard.yaml --count 6
draw fleet_plan.svg fleet plan scenes/fleet.yaml
"$build/apps/cli/tautline" fleet plan scenes/fleet.yaml --quiet --animate $out/fleet_film.svg
draw drive.svg drive scenes/cable_hall.yaml
draw drive_candidates.svg drive scenes/cable_hall.yaml --candidates 4
draw learn_reference.svg learn reference scenes/store_room.yaml --robot-radius 0.3 --count 6
draw learn_path.svg learn evaluate scenes/quiet_room.yaml --policy scenes/quiet_room.onnx --kernels portable
training=$(mktemp -d)
"$build/apps/cli/tautline" learn train scenes/quiet_room.yaml --out "$training" --steps 20000 --hidden 64 64 \
  --evaluate-every 1000 --seeds 3 --kernels portable --quiet
cp "$training/curves.svg" $out/learn_curves.svg
cp "$training/visits.svg" $out/learn_visits.svg
rm -r "$training"
draw learn_baselines.svg learn reference scenes/store_room.yaml --robot-radius 0.3 --baselines
draw engine_taut.svg taut scenes/store_room.yaml
draw engine_classes.svg classes scenes/store_room.yaml
draw engine_choice.svg plan scenes/store_room.yaml --all
python3 -B $out/shrink_png.py $out/willow_demo.png

# What no command draws.
"$build/tests/engine_figures" scenes/store_room.yaml $out
