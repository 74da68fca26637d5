# A bare machine: a minimal Debian 12 in a folder of its own. For scripts that set `label`, which begins what they report, and read
# this file; only root can run them. All mounts and processes are in namespaces of their own, and end with them.
# shellcheck shell=bash

readonly release=bookworm
PATH=$PATH:/usr/sbin:/sbin

# The comment that the script begins with.
usage() { sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "$0"; }
# shellcheck disable=SC2154  # The script's.
say() { echo "$label: $*"; }
fail() { say "failed: $*" >&2; exit 1; }
skip() { say "skipped: $*"; exit 77; }
refuse() { say "$*; see --help" >&2; exit 2; }

folder="" base="" keep=""
# Reads an option that all such scripts have; leaves in `words` how many words it has.
# shellcheck disable=SC2034  # The script shifts by them.
option() {
  words=1
  case $1 in
    --folder | --base)
      [ $# -gt 1 ] || refuse "$1 needs a folder"
      declare -g "${1#--}=$(realpath -m "$2")"
      words=2 ;;
    --keep) keep=yes ;;
    --help) usage; exit 0 ;;
    *) refuse "what is $1?" ;;
  esac
}

# Refuses a folder that exists, then skips the script where no such machine can be made.
require_means() {
  [ -z "$folder" ] || [ ! -e "$folder" ] || refuse "$folder exists already"
  [ "$(id -u)" = 0 ] || skip "only root can run it"
  command -v debootstrap >/dev/null || skip "debootstrap isn't installed: apt-get install debootstrap"
  unshare --mount --pid --fork --mount-proc true 2>/dev/null || skip "nothing can be mounted here"
}

made=() child=""  # Files and folders to remove; the process that is waited for.
finish() {
  local status=$?
  trap - EXIT
  if [ -n "$child" ]; then  # What it started dies with it, but not at once.
    kill -KILL "$child" 2>/dev/null || true
    wait "$child" 2>/dev/null || true
    sleep 1
  fi
  rm -rf --one-file-system "${made[@]}"
  [ -z "$keep" ] || [ ! -d "$folder" ] || say "left in $folder"
  exit "$status"
}
trap finish EXIT
interrupted() { say "interrupted"; exit $((128 + $1)); }
trap 'interrupted 1' HUP
trap 'interrupted 2' INT
trap 'interrupted 15' TERM

# Runs a command in namespaces of its own; a signal to this script ends it at once, with all that it started.
apart() {
  unshare --mount --pid --fork --kill-child --mount-proc "$@" &
  child=$!
  local status=0
  wait $child || status=$?
  child=""
  return $status
}

# This machine's Debian sources of the release, "URI SUITE COMPONENT"; none on other systems.
# shellcheck disable=SC2016  # apt's words, not the shell's.
sources() {
  { apt-get indextargets --format '$(ORIGIN) $(CODENAME) $(REPO_URI) $(COMPONENT)' 'Created-By: Packages' 2>/dev/null || true; } |
    sed -nE "s/^Debian (${release}[^ ]*) ([^ ]+) ([^ ]+)$/\2 \1 \3/p"
}

# Makes Debian's base in a folder.
bootstrap() {
  local mirror log=$temporary/log
  mirror=$(sources | sed -nE "s/^([^ ]+) $release main$/\1/p" | head -n 1)
  say "debootstrap --variant=minbase $release $1 $mirror"
  # shellcheck disable=SC2086  # There may be no mirror.
  apart debootstrap --variant=minbase $release "$1" $mirror >"$log" 2>&1 && return
  tail -n 5 "$log" >&2
  skip "debootstrap can't get Debian $release"
}

# Makes the machine in `folder`, and a folder `temporary`.
make_machine() {
  temporary=$(mktemp -d)
  made+=("$temporary")
  folder=${folder:-$temporary/machine}
  if [ -n "$keep" ]; then  # What is kept isn't made in a folder that is removed.
    [ "$folder" != "$temporary/machine" ] || folder=$(mktemp -d)/machine
  else
    made+=("$folder")
  fi
  if [ -n "$base" ] && [ ! -d "$base" ]; then
    made+=("$base.making")
    bootstrap "$base.making"
    mv "$base.making" "$base"
  fi
  if [ -n "$base" ]; then cp -a "$base" "$folder"; else bootstrap "$folder"; fi
}

# Gives the machine what it takes from this one, so that apt works there.
connect() {
  local etc=$folder/etc certificates=/usr/local/share/ca-certificates
  if [ -n "$(sources)" ]; then sources | sed 's/^/deb /' >"$etc/apt/sources.list"; fi
  apt-config dump --format '%F "%v";%n' Acquire | grep -E '^Acquire::(https?|Check-|Retries)' >"$etc/apt/apt.conf.d/90host" || true
  cp -L /etc/resolv.conf "$etc/"
  [ ! -e /etc/hosts ] || cp -L /etc/hosts "$etc/"
  [ ! -d $certificates ] || { mkdir -p "$folder$certificates" && cp -rL $certificates/. "$folder$certificates/"; }
}

# Runs a command line on the machine, in /root/rotatebook once it is there.
on_machine() {
  say "\$ $1"
  local began=$SECONDS status=0 proxies=() name
  for name in http_proxy https_proxy no_proxy; do
    [ -z "${!name:-}" ] || proxies+=("$name=${!name}")
  done
  apart sh -c 'mount -t proc proc "$0/proc" && { mount -t devpts -o newinstance,ptmxmode=0666 devpts "$0/dev/pts" || true; } &&
    exec chroot "$0" env -i "$@"' "$folder" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root \
    "${proxies[@]}" sh -c "cd; cd rotatebook 2>/dev/null; $1" </dev/null || status=$?
  [ $status = 0 ] || fail "$1 (exit status $status)"
  say "done in $((SECONDS - began)) s: $1"
}
