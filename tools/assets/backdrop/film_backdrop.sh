#!/usr/bin/env bash
# Makes assets/ui/backdrop.ogv, the film behind the start screen: four trainees who move by recorded
# clips in the town, recorded at a server and filmed from the recording.
# Needs the programs of ./run export, and a display (Xvfb will do).
#   tools/assets/backdrop/film_backdrop.sh GODOT
set -euo pipefail
godot=${1:?usage: film_backdrop.sh GODOT}
cd "$(dirname "$(readlink -f "$0")")/../../.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
server=build/export/server/dismount-server.x86_64
client=build/export/client/dismount.x86_64
"$server" --headless --no-header -- --role=server --world=town --time=17.2 --port=7901 \
	--record="$work/town.dismount" --duration=60 &
sleep 5
avatars=(soldier raider civilian_man civilian_woman)
clips=(01_03 01_01 Boxing_Toes 01_03)
for i in 0 1 2 3; do
	"$client" --headless --no-header -- --role=trainee --port=7901 --avatar="${avatars[i]}" \
		--bvh="assets/motion/${clips[i]}.bvh" --bvh-from="$((2 * i))" --duration=60 &
done
wait
"$godot" --rendering-method gl_compatibility --audio-driver Dummy --path . --resolution 1280x720 \
	--write-movie "$work/backdrop.ogv" --fixed-fps 15 --disable-vsync \
	-s tools/assets/backdrop/film_backdrop.gd -- \
	--file="$work/town.dismount" --from=24 --duration=24 --camera=20,10,13 --quality=high
mkdir -p assets/ui
mv "$work/backdrop.ogv" assets/ui/backdrop.ogv
