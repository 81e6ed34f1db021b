#!/usr/bin/env bash
# Opens the window on a virtual display and does what a person does who tunes a paper: light, burn,
# drag, undo, go back, fork, save, compare, record, quit. With a folder, leaves screenshots there.
# usage: drive_window.sh EMBERLEAF [SCALE [FOLDER]]      1: 1280x720, 2: 2560x1440 --ui-scale 2
set -euo pipefail
emberleaf="$1"
scale="${2:-1}"
shots="${3:-}"
home="$(mktemp -d)"
trap 'kill $(jobs -p) 2>/dev/null; rm -rf "$home"' EXIT

# The server itself takes a number that nobody else has, and is asked before anything relies on it:
# xvfb-run's fixed 99 can be answered by a server that is not ours.
: >"$home/display"
Xvfb -displayfd 3 -noreset -nolisten tcp -screen 0 $((1280 * scale))x$((720 * scale))x24 \
    3>"$home/display" 2>"$home/xvfb.log" &
for _ in $(seq 100); do
    export DISPLAY=":$(cat "$home/display")"
    [[ $DISPLAY != : ]] && xdotool getdisplaygeometry >"$home/geometry" 2>&1 && break
    sleep 0.2
done
grep -q '^[0-9]' "$home/geometry" 2>/dev/null || {
    cat "$home/xvfb.log" "$home/geometry" >&2 || true
    echo "drive_window: no virtual display" >&2
    exit 1
}
unset XDG_CONFIG_HOME XDG_DATA_HOME XDG_CACHE_HOME XDG_STATE_HOME XDG_PICTURES_DIR
export HOME="$home"

fail() {
    echo "drive_window: $1" >&2
    kill "$window_pid" 2>/dev/null || true
    exit 1
}
title() { xdotool getwindowname "$window"; }
clock() { title | sed -E 's/.* ([0-9.]+) s.*/\1/'; }
# Waits until a condition holds, for so many seconds.
wait_until() {
    local what="$1" seconds="$2"
    shift 2
    for _ in $(seq $((4 * seconds))); do
        if "$@"; then return; fi
        kill -0 "$window_pid" 2>/dev/null || fail "the window is gone: $what"
        sleep 0.25
    done
    fail "$what: $(title)"
}
titled() { [[ $(title) == $1 ]]; }
later_than() { awk -v a="$(clock)" -v b="$1" 'BEGIN { exit !(a + 0 > b + 0) }'; }
earlier_than() { awk -v a="$(clock)" -v b="$1" 'BEGIN { exit !(a + 0 < b + 0) }'; }
at() { xdotool mousemove $(($1 * scale)) $(($2 * scale)) sleep 0.3; }
drag() { # from x y to x y
    at "$1" "$2"
    xdotool mousedown 1 sleep 0.4
    at $((($1 + $3) / 2)) $((($2 + $4) / 2))
    at "$3" "$4"
    xdotool sleep 0.4 mouseup 1 sleep 0.5
}
shot() {
    if [[ -n $shots ]]; then
        xdotool mousemove $((700 * scale)) $((560 * scale))
        sleep 2
        import -window root "$shots/$1_x$scale.png"
    fi
}

"$emberleaf" paper/corner --ui-scale "$scale" &
window_pid=$!
for _ in $(seq 60); do
    window="$(xdotool search --name 'emberleaf$' 2>/dev/null | head -n 1 || true)"
    [[ -n $window ]] && break
    kill -0 "$window_pid" 2>/dev/null || fail "the window did not open"
    sleep 0.5
done
[[ -n $window ]] || fail "no window appeared"

wait_until "it plays" 20 later_than 0.1
xdotool key space
wait_until "it pauses" 10 titled '*, paused*'
paused="$(title)"
sleep 1
[[ $paused == "$(title)" ]] || fail "the time goes on while paused: $paused, $(title)"
shot 1_paused

xdotool key ctrl+Left
wait_until "to the start" 10 titled '* 0.00 s, paused*'
xdotool keydown ctrl
at 540 395
xdotool click 1 sleep 0.3 keyup ctrl
wait_until "a lighter that is moved is an edit" 10 titled '*\* - *'
xdotool key space
wait_until "it burns" 60 later_than 1.5
shot 2_lit

drag 1102 130 1135 130 # c_s
drag 1154 76 1180 76   # grammage
xdotool key space
wait_until "it pauses again" 10 titled '*, paused*'
later_than 1.4 || fail "a live parameter restarts the scene"
shot 3_dragged
xdotool key ctrl+z ctrl+z sleep 0.5
shot 4_undone

there="$(clock)"
at 60 650
xdotool click 1
wait_until "going back" 10 earlier_than "$there"
shot 5_back
drag 1154 76 1190 76
xdotool key space
wait_until "it goes on from there" 60 later_than 0.8
xdotool key space
wait_until "it pauses once more" 10 titled '*, paused*'
shot 6_forked

xdotool key F1
shot 7_help
xdotool key Escape sleep 0.5
kill -0 "$window_pid" 2>/dev/null || fail "Escape quits"
xdotool key F3 F4
shot 8_figures
xdotool key F3 F4

before="$(clock)"
xdotool key ctrl+s sleep 3
xdotool type --delay 80 "quick v r"
shot 9_save_as
xdotool key Return
wait_until "saving" 10 test -f "$home/.local/share/emberleaf/presets/quick_v_r.toml"
[[ $(clock) == "$before" ]] || fail "typing triggers a shortcut: $(title)"
wait_until "what is saved is not modified" 10 titled 'quick_v_r - *'

xdotool key ctrl+d d
shot 10_side_by_side
xdotool key x sleep 0.5 key x sleep 0.5 key d sleep 0.5

xdotool key ctrl+e
sleep 1.5
shot 11_record
xdotool key Return
recorded() { compgen -G "$home/Pictures/emberleaf/*/frame_0010.png" >/dev/null; }
wait_until "recording" 120 recorded
shot 12_recording
xdotool key Escape sleep 0.5 key F12
pictured() { compgen -G "$home/Pictures/emberleaf/*.png" >/dev/null; }
wait_until "a screenshot" 30 pictured
xdotool key ctrl+o
shot 13_presets
xdotool key Escape sleep 0.5 key ctrl+r sleep 1
wait_until "reading it again" 20 titled 'quick_v_r - *'

xdotool key ctrl+q
for _ in $(seq 60); do
    kill -0 "$window_pid" 2>/dev/null || break
    sleep 0.25
done
kill -0 "$window_pid" 2>/dev/null && fail "Ctrl+Q does not quit"
wait "$window_pid" || fail "exit code $?"
[[ -f $home/.config/emberleaf/settings ]] || fail "nothing is remembered"
echo "lit, burnt, edited, undone, gone back, forked, saved, compared, recorded, quit"
