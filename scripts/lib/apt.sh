# Sourced by scripts that make a bare Debian.
# shellcheck shell=bash

# sources_of_apt: where this machine gets its packages, as lines of sources.list.
sources_of_apt() {
  # shellcheck disable=SC2016  # apt-get puts the values in
  apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' | sort -u |
    awk '{ print "deb " $1 " " $2 " " $3 }'
}

# bare_debian FOLDER [OPTION...]: a Debian 12 with hardly anything in it, which gets its packages from where this machine does.
bare_debian() {
  local folder=$1 mirror
  shift
  mirror=$(sources_of_apt | awk '$3 == "bookworm" && !found++ { print $2 }')
  [[ -n $mirror ]] || { echo "apt knows no source of bookworm" >&2 && return 1; }
  debootstrap --variant=minbase "$@" bookworm "$folder" "$mirror"
  sources_of_apt >"$folder/etc/apt/sources.list"
  # What this machine trusts besides, its own building trusts too.
  mkdir -p "$folder/usr/local/share/ca-certificates"
  find /usr/local/share/ca-certificates -name '*.crt' -exec cp {} "$folder/usr/local/share/ca-certificates/" \;
}
