#!/bin/sh
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# fails_with.sh SENTENCE COMMAND ...
# Succeeds if the command, a compiler, fails and what it prints contains the sentence.

sentence=$1
shift
export LC_ALL=C
if output=$("$@" 2>&1); then
  echo "compiled, but must not"
  exit 1
fi
printf '%s\n' "$output"
case $output in
  *"$sentence"*) exit 0 ;;
esac
echo "not found: $sentence"
exit 1
