#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs test programs in a small virtual machine that has the kernel's HID stack, a camera, or both, or a sound card. See README.md.
#   run_in_vm.sh [--camera|--console|--sound] CACHE_FOLDER TEST_PROGRAM... [-- FILES...]
set -euo pipefail
here=$(cd "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
modules=(hid hid-generic uhid evdev)
share_usr=
case ${1:-} in
    --camera) modules=() share_usr=1 ;;
    --console) share_usr=1 ;;
    --sound) modules=(snd-aloop) share_usr=1 ;;
esac
if [[ -n $share_usr ]]; then
    modules+=(virtio_pci 9pnet_virtio 9p)
    [[ $1 == --sound ]] || modules+=(vivid)
    shift
fi
# One camera and nothing else of what the driver can play.
declare -A parameters=([vivid]='n_devs=1 node_types=0x1 num_inputs=1 input_types=0' [snd-aloop]='pcm_substreams=1')
skipped=77

skip() {
    printf 'run_in_vm: skipped: %s\n' "$*"
    exit "$skipped"
}

if (($# < 2)) || [[ $2 == -- ]]; then
    printf 'usage: run_in_vm.sh [--camera|--console|--sound] CACHE_FOLDER TEST_PROGRAM... [-- FILES...]\n' >&2
    exit 2
fi
mkdir -p "$1"
cache=$(cd "$1" && pwd)
shift
programs=()
while (($# > 0)) && [[ $1 != -- ]]; do
    programs+=("$1")
    shift
done
(($# == 0)) || shift
for tool in qemu-system-x86_64 busybox cpio apt-get dpkg-deb; do
    command -v "$tool" >/dev/null || skip "$tool is missing (packaging/install_dependencies.sh --test installs it)"
done

# Fetches the newest kernel package once.
exec 9>"$cache/lock"
flock 9
if ! compgen -G "$cache/kernel/boot/vmlinuz-*" >/dev/null; then
    package=$(apt-cache depends linux-image-amd64 2>/dev/null | sed -n 's/.*Depends: //p' | head -n 1)
    [[ -n $package ]] || skip "apt knows no linux-image-amd64"
    rm -rf "$cache/download" "$cache/unpacked"
    mkdir -p "$cache/download"
    (cd "$cache/download" && apt-get -q download "$package") || skip "$package cannot be downloaded"
    dpkg-deb -x "$cache/download"/*.deb "$cache/unpacked"
    rm -rf "$cache/download" "$cache/kernel"
    mv "$cache/unpacked" "$cache/kernel"
fi
if ! compgen -G "$cache/kernel/lib/modules/*/modules.dep" >/dev/null; then
    version=$(basename "$(compgen -G "$cache/kernel/lib/modules/*" | head -n 1)")
    busybox depmod -b "$cache/kernel" "$version" || skip "depmod does not read the kernel package"
fi
flock -u 9
kernel=$(compgen -G "$cache/kernel/boot/vmlinuz-*" | head -n 1)
version=${kernel##*/vmlinuz-}
module_folder=$cache/kernel/lib/modules/$version

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/root
mkdir -p "$root"/{bin,dev,proc,sys,tmp,run,etc,modules,test,lib64}
cp "$(command -v busybox)" "$root/bin/busybox"
cp "$here/init" "$root/init"
chmod 755 "$root/init"
# A module after those that it needs; modules.dep lists them nearest first.
add_module() {
    local file=$1 name
    name=$(basename "$file" .xz)
    [[ ! -e $root/modules/$name ]] || return 0
    case $file in
        *.xz) xz -dc "$module_folder/$file" >"$root/modules/$name" ;;
        *) cp "$module_folder/$file" "$root/modules/$name" ;;
    esac
    printf '%s %s\n' "$name" "${parameters[${name%.ko}]:-}" >>"$root/modules/order"
}
for module in "${modules[@]}"; do
    line=$(grep -E "/$module\.ko(\.xz)?:" "$module_folder/modules.dep" || true)
    [[ -n $line ]] || skip "the kernel package has no module $module"
    for needed in $(printf '%s\n' ${line#*:} | tac); do
        add_module "$needed"
    done
    add_module "${line%%:*}"
done
share=()
if [[ -n $share_usr ]]; then
    # A program with hundreds of libraries: the machine sees ours, and cannot write to them.
    rmdir "$root/lib64"
    ln -s usr/lib "$root/lib"
    ln -s usr/lib64 "$root/lib64"
    mkdir "$root/usr"
    cp /etc/ld.so.cache "$root/etc/"
    [[ ! -d /etc/alternatives ]] || cp -P -r /etc/alternatives "$root/etc/"
    share=(-virtfs local,path=/usr,mount_tag=usr,security_model=none,readonly=on)
fi
for file in "${programs[@]}" "$@"; do
    cp -L "$file" "$root/test/"
    [[ -z $share_usr ]] || continue
    ldd "$file" 2>/dev/null | grep -oE '/[^ ]+' | sort -u | while read -r library; do
        [[ -e $root$library ]] || install -D "$library" "$root$library"
    done
done
printf '%s\n' "${programs[@]##*/}" >"$root/test/.programs"
(cd "$root" && find . | cpio -o -H newc --quiet -R 0:0) | gzip -1 >"$work/initrd"

# Emulated: KVM is not there, or does not work, on many test machines.
# no_timer_check: on a busy machine the kernel can find the emulated timer too slow, and stop.
status=0
timeout -k 5 "${VM_TIMEOUT_S:-400}" qemu-system-x86_64 -machine q35 -accel tcg,thread=multi -cpu max -smp 2 -m 1024 \
    -kernel "$kernel" -initrd "$work/initrd" -append "console=ttyS0 quiet panic=-1 no_timer_check" \
    -nographic -no-reboot -nic none "${share[@]}" </dev/null 2>&1 | tr -d '\r' | tee "$work/log" || status=$?
result=$(sed -n 's/^VM_RESULT=//p' "$work/log" | tail -n 1)
if [[ -z $result ]]; then
    printf 'run_in_vm: the machine ended without a result (qemu: %s)\n' "$status" >&2
    exit 1
fi
exit "$result"
