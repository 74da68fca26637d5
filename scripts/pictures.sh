#!/usr/bin/env bash
# Draws the pictures of docs/pictures anew: one for each overlay, shape and look. pictures.sh PROGRAM
set -euo pipefail
program=$(realpath "$1")
cd "$(dirname "$0")/.."
folder=docs/pictures
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$folder"

# draw NAME SCENE OPTION...: one picture, packed for a page
draw() {
  "$program" still "$2" -o "$work/$1.png" --size 480x270 --set look.supersample=2 --quiet "${@:3}"
  cwebp -quiet -q 82 "$work/$1.png" -o "$folder/$1.webp"
}

for overlay in caption settings clock axes omega momentum trail polhode half_turns poinsot energy_ladder; do
  draw "overlay-$overlay" scenes/starter.toml --time 8.3 --set "overlay.show=[\"$overlay\"]" --set overlay.scale=1.5
done
for overlay in error ghost; do
  draw "overlay-$overlay" scenes/starter.toml --time 6 --set "overlay.show=[\"$overlay\"]" \
    --set simulation.integrator=euler --set simulation.substeps=16 --set overlay.scale=1.5
done
draw overlay-forces scenes/bodies/disc-tips.toml --time 4.6 --set 'overlay.show=["forces"]' --set overlay.scale=1.5
for overlay in springs energy; do
  draw "overlay-$overlay" scenes/particles-soft.toml --time 2 --set "overlay.show=[\"$overlay\"]" --set overlay.scale=1.5
done

cat >"$work/shape.toml" <<'EOF'
[initial]
angular_velocity = [0.5, 1.2, 0.2]
EOF
for shape in box phone cards racket t-handle wing-nut toutatis disc weighted-disc ellipsoid cylinder; do
  sed "1i [body]\nshape = \"$shape\"" "$work/shape.toml" >"$work/$shape.toml"
  draw "shape-$shape" "$work/$shape.toml" --time 1
done

for look in studio stars white '#2b5d8a'; do
  draw "look-${look#\#}" scenes/starter.toml --time 2.2 --set 'overlay.show=[]' --set "look.background=$look"
done
draw look-cloth scenes/starter.toml --time 2.2 --set 'overlay.show=[]' --set 'book.color="#2b5d8a"'
for frame in world body momentum turning; do
  draw "frame-$frame" scenes/starter.toml --time 1.5 --set 'overlay.show=[]' --set look.background=stars \
    --set "camera.frame=$frame"
done
draw sink scenes/bodies/explorer-1.toml --time 9
for moments in 1 8; do
  draw "look-blur-$moments" scenes/starter.toml --time 2.2 --set 'overlay.show=[]' \
    --set initial.angular_velocity='["1.5 turn/s", 0, 0]' --set look.motion_blur=$moments
done
