#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the packages into a clean tree of Debian 12 and uses them there as a person would. Needs root rights.
#   test_deb.sh [TREE]      an existing tree is used again
set -euo pipefail
source "$(dirname -- "${BASH_SOURCE[0]}")/build_environment.sh"
source "$root/packaging/debian_tree.sh"
tree=${1:-$root/build/debian-tree}

fail() {
    printf 'test_deb: %s\n' "$*" >&2
    exit 1
}
((EUID == 0)) || fail "debootstrap needs root rights"
"$root/packaging/make_deb.sh"
package=$(compgen -G "$root/build/package/teleta-console_*.deb")
module=$(compgen -G "$root/build/package/python3-teleta_*.deb")
site=$(compgen -G "$root/build/package/teleta-site_*.deb")

for each in "$package" "$module" "$site"; do
    lintian --allow-root --fail-on error --suppress-tags bogus-mail-host,no-changelog,embedded-library "$each" || fail "lintian refuses $each"
done

[[ -x $tree/usr/bin/apt-get ]] || make_tree "$tree"
enter_tree "$tree"

cp "$package" "$tree/tmp/teleta-console.deb"
cp "$module" "$tree/tmp/python3-teleta.deb"
cp "$site" "$tree/tmp/teleta-site.deb"
inside apt-get -q update

printf '\n== the Python module alone in the clean tree\n'
inside apt-get -q install -y --no-install-recommends /tmp/python3-teleta.deb
[[ ! -e $tree/usr/bin/teleta ]] || fail "the module brings the programs"
inside /usr/bin/python3 -c 'import teleta; print("teleta", teleta.__version__)'
for example in features_of_csv recording_to_arrays; do
    inside /usr/bin/python3 "/usr/share/doc/python3-teleta/examples/$example.py"
done
inside apt-get -q remove -y python3-teleta >/dev/null
[[ ! -e $tree/usr/lib/python3/dist-packages/teleta ]] || fail "the module leaves files behind"

printf '\n== the robot'\''s end of a link alone, with a simulated arm\n'
inside apt-get -q install -y --no-install-recommends /tmp/teleta-site.deb
[[ ! -e $tree/usr/bin/teleta ]] || fail "teleta-site brings the other programs"
inside teleta-site --version
for file in bin/teleta-site lib/systemd/system/teleta-site.service lib/sysusers.d/teleta-site.conf share/man/man8/teleta-site.8.gz \
    share/bash-completion/completions/teleta-site share/doc/teleta-site/copyright share/doc/teleta-site/examples/site.toml; do
    inside dpkg -L teleta-site | grep -qxF "/usr/$file" || fail "teleta-site does not hold /usr/$file"
done
for part in teleta_opencv_pictures teleta_opencv_video; do
    inside ldd "/usr/lib/teleta-site/$part.so" >"$tree/tmp/part" || fail "teleta-site does not hold $part.so"
    ! grep "not found" "$tree/tmp/part" || fail "$part.so of teleta-site lacks a library"
done
[[ ! -e $tree/etc/systemd/system/multi-user.target.wants/teleta-site.service ]] || fail "the service is enabled"
printf '%s\n' 'kind = "site"' 'name = "lab"' 'record = true' '[operator]' 'interface = "lo"' 'security = "none"' '[[device]]' \
    'id = "practice"' 'scene = "teleoperation"' >"$tree/tmp/site.toml"
inside teleta-site /tmp/site.toml --check
inside mkdir -p /tmp/site-recordings
inside timeout --preserve-status --signal TERM 4 teleta-site /tmp/site.toml --recordings /tmp/site-recordings
compgen -G "$tree/tmp/site-recordings/lab-*.teleta" >/dev/null || fail "teleta-site left no recording"
inside apt-get -q remove -y teleta-site >/dev/null
[[ ! -e $tree/usr/bin/teleta-site ]] || fail "teleta-site leaves its program behind"

inside apt-get -q install -y --no-install-recommends /tmp/teleta-console.deb
inside apt-get -q install -y --no-install-recommends xvfb xauth fonts-dejavu-core

printf '\n== in the clean tree\n'
inside teleta --version
inside teleta-console --version
inside teleta simulate --list
inside teleta simulate tactile-indenter --duration 1 --out /tmp/run >/dev/null
[[ -s $tree/tmp/run/summary.json ]] || fail "simulate left no summary"
# Two of the parts that are loaded when they are needed.
inside teleta simulate vtacarm-calibration --duration 1 --out /tmp/camera >/dev/null
[[ -s $tree/tmp/camera/reference.png ]] || fail "simulate left no picture of the camera"
inside teleta study rehearse --participants 2 --seed 1 --out /tmp/study >/dev/null
inside teleta study analyze /tmp/study --out /tmp/results >/dev/null
[[ -s $tree/tmp/results/anova.csv ]] || fail "analyze left no ANOVA"
for file in man/man1/teleta.1.gz man/man1/teleta-console.1.gz man/man1/teleta-stiffness.1.gz \
    applications/org.teleta.Console.desktop metainfo/org.teleta.Console.metainfo.xml \
    icons/hicolor/scalable/apps/teleta-console.svg bash-completion/completions/teleta doc/teleta-console/copyright \
    teleta-console/teleta_msgs/msg/Touch.msg teleta-console/sites/lab.toml \
    doc/teleta-console/changelog.gz doc/teleta-console/CITATION.cff mime/packages/org.teleta.Console.xml; do
    [[ -s $tree/usr/share/$file || $file == doc/* || $file == man/* ]] || fail "/usr/share/$file is missing"
    inside dpkg -L teleta-console | grep -qxF "/usr/share/$file" || fail "the package does not hold /usr/share/$file"
done
inside dpkg -L teleta-console | grep -q '/lib/udev/rules.d/70-teleta-bracelet.rules' || fail "the udev rules are missing"
inside mkdir -p -m 700 /tmp/runtime
inside env XDG_RUNTIME_DIR=/tmp/runtime QT_QPA_PLATFORM=xcb LIBGL_ALWAYS_SOFTWARE=1 \
    xvfb-run -a -s "-screen 0 1600x1000x24" teleta-console --scene teleta-touch --screenshot /tmp/console.png --after 9
[[ -s $tree/tmp/console.png ]] || fail "the console left no picture"
cp "$tree/tmp/console.png" "$root/build/package/console.png"
inside apt-get -q remove -y teleta-console >/dev/null
[[ ! -e $tree/usr/bin/teleta ]] || fail "the package leaves its programs behind"
printf 'test_deb: passed; picture %s\n' "$root/build/package/console.png"
