#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Draws the pictures of docs/ anew, by the built command line and, of contact, a program of the tests:
# docs/pictures/make.sh [FIRMA] [DRAW_CONTACTS]
set -euo pipefail
cd "$(dirname "$0")/../.."
firma=${1:-build/release/bin/firma}
contacts=${2:-build/test/bin/draw_contacts}
pictures=docs/pictures

"$contacts" > $pictures/contacts.svg

"$firma" draw levels/first.obj --blasts $pictures/crater.csv --view --before-after \
    --eye 24.2,31.6,2.4 --look 20.2,36.4,1.6 -o $pictures/crater.png

"$firma" draw levels/depot.map --view --eye 10.5,13.2,5.9 --look 17,2,2 -o $pictures/depot_hall.png
"$firma" draw levels/depot.map --view --rooms --eye 33,8,2.2 --look 12,7,2.6 -o $pictures/depot_view_rooms.png
"$firma" draw levels/depot.map --view --eye 60,-18,14 --look 36,6,5 -o $pictures/depot_yard.png
"$firma" draw levels/depot.map --below 3 --at 8 -o $pictures/depot_rooms.svg
bare=$(mktemp -d)/bare.map
sed 's/func_areaportal/trigger/; s,common/portal,common/trigger,' levels/depot.map > "$bare"
"$firma" draw "$bare" --rooms auto --below 3 --at 8 -o $pictures/depot_auto_rooms.svg
rm -r "$(dirname "$bare")"

folder=$(mktemp -d)
"$firma" demo levels/depot.map --craters 1 -o "$folder/demo.svg"
mv "$folder/demo_view.png" $pictures/depot_bridge.png
"$firma" demo levels/depot.map --frames "$folder"
mv "$folder/bridge.png" $pictures/fight_bridge.png
mv "$folder/fight.png" $pictures/fight.png
rm -r "$folder"
