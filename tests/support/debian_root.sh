# shellcheck shell=bash
# A bare Debian in a folder, as somebody who has just installed it: for tests of packages and of what cannot stand beside other packages. Source after third_party/setup.sh.

# debian_root FOLDER PACKAGE ...: this machine's own release, from its own mirror, with just these packages. Kept: an unfinished one is made again.
debian_root() {
  local folder=$1 release mirror tool
  shift
  ((EUID == 0)) || fail "debootstrap and chroot want root."
  for tool in debootstrap chroot unshare; do command -v "$tool" >/dev/null || fail "$tool is not there (Debian: debootstrap, util-linux)."; done
  if [[ -e $folder/made ]]; then return; fi
  release=$(. /etc/os-release && echo "$VERSION_CODENAME")
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Codename: $release" | head -1)
  say "Making a root of $release in $folder"
  rm -rf "$folder"
  quietly "The root could not be made." debootstrap --variant=minbase "$release" "$folder" "$mirror"
  cp /etc/resolv.conf "$folder/etc/"
  if (($# > 0)); then quietly "Packages could not be installed there." in_root "$folder" "apt-get update && apt-get install -y --no-install-recommends $*"; fi
  touch "$folder/made"
}

# in_root FOLDER WORDS: a shell's words in the root, as its own root user, with nothing of this machine's environment.
in_root() {
  unshare --mount --pid --fork chroot "$1" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    sh -c "mount -t proc proc /proc && $2"
}
