# SPDX-License-Identifier: GPL-3.0-or-later
# For make_flatpak.sh, which sources it after names.sh: Flatpak runtimes out of Debian 12 packages. Needs fail() of that script.
# shellcheck shell=bash
source "$root/packaging/debian_tree.sh"

# install_packages DEPENDENCIES: into the tree that was entered.
install_packages() {
    local language
    inside apt-get -q update &&
        inside apt-get -q install -y --no-install-recommends locales || return 1
    # The languages of the program; in others the C library speaks English, the program what it is told to.
    for language in en_US fr_FR ja_JP zh_CN; do
        inside localedef -i "$language" -f UTF-8 "$language.UTF-8" || return 1
    done
    inside apt-get -q satisfy -y --no-install-recommends "$1" && inside apt-get -q clean
}

# reduce KIND: takes away from the /usr in the current folder what belongs to this machine, what only installs packages, and what
# nobody reads there. Licences stay.
reduce() {
    rm -rf etc/apt etc/resolv.conf etc/hosts etc/hostname etc/machine-id etc/{passwd,group,shadow,gshadow,subuid,subgid}{,-}
    rm -rf sbin/policy-rc.d lib/{apt,systemd,udev} share/{man,info,lintian,linda,bug,i18n,locale,menu} games local src
    find share/doc -type f ! -name copyright -delete
    find share/doc -type l -delete
    find share/doc -type d -empty -delete
    if [[ $1 == Platform ]]; then
        rm -rf bin/{apt,deb,dpkg,perl}* lib/{dpkg,*/perl-base} share/{debconf,dpkg,perl,perl5} include
    fi
}

# make_runtime Platform|Sdk DEPENDENCIES: a runtime with these packages (as in the Depends line of a Debian package) in the repository,
# installed for building; at once when it is there already from the same list. The Sdk's tree stays in $work/Sdk.
make_runtime() {
    local kind=$1 dependencies=$2 name=$platform
    [[ $kind == Platform ]] || name=$sdk
    local stamp="$work/$kind.stamp" log="$work/$kind.log" folder="$work/$kind" files="$work/$kind-files" arch wanted
    wanted=$(printf '%s\n' "$dependencies" | cat - "$root"/packaging/{debian_tree,flatpak/names,flatpak/runtime}.sh | sha256sum)
    if [[ -f $stamp && $(<"$stamp") == "$wanted" ]] && flatpak --user info "$name" >/dev/null 2>&1; then
        return
    fi
    printf 'Making the runtime %s out of Debian packages\n' "$name"
    rm -f "$stamp"
    if [[ ! -f $work/base.stamp ]]; then
        make_tree "$work/base"
        touch "$work/base.stamp"
    fi
    rm -rf --one-file-system -- "$folder" "$files"
    cp -a "$work/base" "$folder"
    enter_tree "$folder"
    install_packages "$dependencies" >"$log" 2>&1 || fail "the packages of $name could not be installed, see $log"
    leave_tree

    # A runtime is /usr, with /etc as its etc. The files are linked, so that the tree stays whole.
    mkdir -p "$files/files"
    cp -al "$folder/usr" "$files/usr"
    cp -a "$folder/etc" "$files/usr/etc"
    (cd "$files/usr" && reduce "$kind")
    # Fonts of the machine and of its user hold the scripts that the runtime's own font lacks.
    cp "$root/packaging/flatpak/fonts.conf" "$files/usr/etc/fonts/local.conf"
    # In a Flatpak this folder is the user's cache again, and fontconfig would lose fonts that it finds in both.
    sed -i '/<cachedir>\/var\/cache\/fontconfig</d' "$files/usr/etc/fonts/fonts.conf"
    arch=$(flatpak --default-arch)
    printf '[Runtime]\nname=%s\nruntime=%s\nsdk=%s\n' "$name" "$platform/$arch/$runtime_version" "$sdk/$arch/$runtime_version" \
        >"$files/metadata"
    {
        ostree init --repo="$repository" --mode=bare-user-only &&
            flatpak build-export --runtime "$repository" "$files" "$runtime_version" &&
            flatpak --user remote-add --if-not-exists --no-gpg-verify teleta "$repository" &&
            flatpak --user install --or-update --noninteractive -y teleta "$name//$runtime_version"
    } >>"$log" 2>&1 || fail "flatpak refuses the runtime $name, see $log"
    rm -rf -- "$files"
    [[ $kind == Sdk ]] || rm -rf --one-file-system -- "$folder"
    printf '%s\n' "$wanted" >"$stamp"
}
