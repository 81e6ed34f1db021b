#!/usr/bin/env bash
# Opens the window on a virtual display, presses keys and drags the mouse as a person would, and
# checks that it burns, pauses, and ends well. usage: drive_window.sh EMBERLEAF
set -euo pipefail
emberleaf="$1"
if [[ -z ${INSIDE_XVFB:-} ]]; then
    INSIDE_XVFB=1 exec xvfb-run -a -s "-screen 0 1280x720x24" bash "$0" "$emberleaf"
fi

fail() {
    echo "drive_window: $1" >&2
    kill "$window_pid" 2>/dev/null || true
    exit 1
}

"$emberleaf" paper/corner &
window_pid=$!
for _ in $(seq 60); do
    window="$(xdotool search --name 'emberleaf$' 2>/dev/null | head -n 1 || true)"
    [[ -n $window ]] && break
    kill -0 "$window_pid" 2>/dev/null || fail "the window did not open"
    sleep 0.5
done
[[ -n $window ]] || fail "no window appeared"
sleep 4

title() { xdotool getwindowname "$window"; }
before="$(title)"
sleep 3
after="$(title)"
[[ $before != "$after" ]] || fail "the time in the title stands still while playing: $before"

xdotool key space
sleep 2
paused="$(title)"
sleep 2
[[ $paused == "$(title)" ]] || fail "the time goes on while paused"

xdotool mousemove 400 400 mousedown 1 mousemove_relative 60 20 mouseup 1
xdotool key v key v key F1
sleep 1
xdotool key Escape
sleep 1
kill -0 "$window_pid" 2>/dev/null || fail "Escape quits"
[[ $paused == "$(title)" ]] || fail "looking around changes the time: $(title)"

# a typed grammage restarts the scene when it is complete; letters in the field are no shortcuts
xdotool keydown ctrl mousemove 1175 76 sleep 0.5 click 1 keyup ctrl sleep 1
xdotool type --delay 100 "120r "
sleep 1
[[ $paused == "$(title)" ]] || fail "typing triggers a shortcut: $(title)"
xdotool key Return
sleep 2
[[ $(title) == *" 0.00 s, paused"* ]] || fail "a typed grammage does not restart: $(title)"
xdotool key Right
sleep 1
[[ $(title) == *" 0.02 s, paused"* ]] || fail "a step is not one tick: $(title)"

xdotool key ctrl+q
for _ in $(seq 40); do
    kill -0 "$window_pid" 2>/dev/null || break
    sleep 0.25
done
kill -0 "$window_pid" 2>/dev/null && fail "Ctrl+Q does not quit"
wait "$window_pid" || fail "exit code $?"
echo "opened, played to $after, paused, quit"
