#!/usr/bin/env bash
# rv32_restarts.sh ELF: the product image for RV32, sent to where there is no memory, records the crash, restarts and
# says so, with a clock that went on until then.
set -euo pipefail
source "$(dirname "$0")/../integration/common.sh"
elf=$1
source "$(dirname "$0")/board_session.sh"
timeout --kill-after=1 60 qemu-system-riscv32 -bios none -M virt -display none -monitor none -serial null \
  -chardev "file,id=console,path=$scratch/console" -semihosting-config enable=on,target=native,chardev=console \
  -gdb "unix:$scratch/gdb,server=on,wait=off" -kernel "$elf" </dev/null >"$scratch/qemu.log" 2>&1 &
wait_for test -e "$scratch/console"
wait_for booted
sleep 0.1 # of uptime
python3 - "$scratch/gdb" <<'EOF'
import socket, sys

debugger = socket.socket(socket.AF_UNIX)
debugger.connect(sys.argv[1])


received = b""


def ask(command, expected):
    """Sends a command and waits for the answer that begins so: a stop is told unasked, too, between any two."""
    global received
    debugger.sendall(f"${command}#{sum(command.encode()) % 256:02x}".encode())
    while True:
        start, end = received.find(b"$"), received.find(b"#")
        while start < 0 or end < 0 or len(received) < end + 3:
            received += debugger.recv(4096) or sys.exit("QEMU is gone")
            start, end = received.find(b"$"), received.find(b"#")
        answer, received = received[start + 1 : end], received[end + 3 :]
        debugger.sendall(b"+")
        if answer.startswith(expected):
            return
        if not answer.startswith(b"T"):
            sys.exit(f"{command}: {answer!r}")


debugger.settimeout(60)
ask("?", b"T")  # it stands still
ask("qXfer:features:read:target.xml:0,ffb", b"l")  # QEMU lets registers be written only after this
ask("P20=00000040", b"OK")  # the program counter
ask("D", b"OK")  # it goes on
EOF
crashed() { (($(grep -c '^image: ' "$scratch/console") == 2)); }
wait_for crashed
cat "$scratch/console"
grep -q 'ready.*reset cause fault' "$scratch/console"
grep -qE '^crash: exception 2 at 0x40000000 .*, after [1-9][0-9]* ms' "$scratch/console"
