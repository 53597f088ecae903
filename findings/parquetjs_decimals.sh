#!/usr/bin/env bash
# Package:  npm @dsnp/parquetjs 1.8.8, beside hyparquet 1.31.5, which reads the same file.
# Expected: a column DECIMAL of precision 9 and scale 2 is read as it was written, 20.15 as 20.15.
# Seen:     every second sample is 0, and the others come at twice their place: 21.25 0 21.5 0. The second half of the
#           column is lost. Nothing is thrown. The file is right, for hyparquet reads it, but 20.15 was cut to 20.14 on
#           writing. With precision 18 all places are right.
# Matters:  loggers store temperatures as decimals. The count of the samples is right, and half of them are plausible: a
#           temperature that runs at half its speed, with gaps at 0.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
npm_packages @dsnp/parquetjs@1.8.8 hyparquet@1.31.5
cat >decimals.mjs <<'J'
import parquetjs from '@dsnp/parquetjs';
import { asyncBufferFromFile, parquetReadObjects } from 'hyparquet';
const temperatures = [21.25, 21.5, 21.75, 22, 22.25, 20.15];
for (const precision of [9, 18]) {
  const schema = new parquetjs.ParquetSchema({ t: { type: 'DECIMAL', precision, scale: 2 } });
  const writer = await parquetjs.ParquetWriter.openFile(schema, 'run.parquet');
  for (const t of temperatures) await writer.appendRow({ t });
  await writer.close();
  const there = await parquetReadObjects({ file: await asyncBufferFromFile('run.parquet') });
  console.log(`precision ${precision}, hyparquet:`, there.map(({ t }) => t).join(' '));
  const reader = await parquetjs.ParquetReader.openFile('run.parquet');
  const cursor = reader.getCursor();
  const read = [];
  for (let row = await cursor.next(); row; row = await cursor.next()) read.push(row.t);
  await reader.close();
  console.log(`precision ${precision}, parquetjs:`, read.join(' '));
}
J
stated 'precision 9, hyparquet: 21.25 21.5 21.75 22 22.25 20.14
precision 9, parquetjs: 21.25 0 21.5 0 21.75 0
precision 18, hyparquet: 21.25 21.5 21.75 22 22.25 20.14
precision 18, parquetjs: 21.25 21.5 21.75 22 22.25 20.14' "$(node decimals.mjs)"
