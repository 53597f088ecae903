// write_logs.mjs PACKAGES: the same recording as run.mcap, run.bag, run.db3, run.ulg, run.h5 and
// run.parquet in the current folder, by the formats' own writers or, where there is none, by their specifications; and as CSV what `fogcomp convert` is to
// make of them. PACKAGES: the folder of the importers and their packages.
import { execFileSync } from "node:child_process";
import fs from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const folder = path.resolve(process.argv[2]);
const required = createRequire(path.join(folder, "import.mjs"));
const imported = (file) => import(pathToFileURL(path.join(folder, "node_modules", file)));

// The recording: 50 Hz, stamps that no double holds, a temperature every 25 samples; the log has them 3 and 2 ms later.
const SAMPLES = 400;
const START_NS = 1_700_000_000_000_000_001n;
const stampNs = (i) => START_NS + BigInt(i) * 20_000_007n;
const rate = (i) => [i / 1024 + 1 / 3, -i * 1e-7, Math.sin(i) / 7];
const temperature = (i) => 20 + Math.floor(i / 25) / 8 + 0.1;
const loggedNs = ({ type, i }) => stampNs(i) + (type === "Imu" ? 3_000_000n : 2_000_000n);
const bootUs = (i) => 5_000_000n + (stampNs(i) - START_NS) / 1000n; // since power-on

const seconds = (ns) => `${ns / 1_000_000_000n}.${String(ns % 1_000_000_000n).padStart(9, "0")}`;
const AXES = "rate_x [rad/s],rate_y [rad/s],rate_z [rad/s]";

// The messages in the order of the log: at samples 10, 35, ... a temperature comes first.
function* messages() {
  for (let i = 0; i < SAMPLES; ++i) {
    if (i % 25 === 10) yield { topic: "/temp", type: "Temperature", i };
    yield { topic: "/imu/data", type: "Imu", i };
  }
}

function writeExpected() {
  const held = (i) => (i < 10 ? "" : temperature(i - ((i - 10) % 25)));
  const rows = Array.from({ length: SAMPLES }, (_, i) => [seconds(stampNs(i)), held(i), ...rate(i)].join(","));
  fs.writeFileSync("ros.csv", [`time [s],temperature_degc,${AXES}`, ...rows, ""].join("\n"));
  const logged = rows.map((row, i) => row.replace(/^[^,]*/, seconds(loggedNs({ type: "Imu", i }))));
  fs.writeFileSync("logged.csv", [`time [s],temperature_degc,${AXES}`, ...logged, ""].join("\n"));
  const micro = (i) => seconds(bootUs(i) * 1000n).slice(0, -3);
  const single = rows.map((_, i) => [micro(i), ...[temperature(i), ...rate(i)].map(Math.fround)].join(","));
  fs.writeFileSync("ulog.csv", [`time_s,temperature_degc,${AXES}`, ...single, ""].join("\n"));
  const matrix = rows.map((_, i) => rate(i).join(","));
  fs.writeFileSync("matrix.csv", ["gyro_1 [rad/s],gyro_2 [rad/s],gyro_3 [rad/s]", ...matrix, ""].join("\n"));
  const flat = rows.map((_, i) =>
    [seconds(stampNs(i)), i % 100 ? temperature(i) : "", rate(i)[2], i, (i * -0.01).toFixed(2)].join(","),
  );
  fs.writeFileSync("parquet.csv", ["stamp [s],temp [degC],gyro_z [rad/s],n,volt", ...flat, ""].join("\n"));
  const columns = rows.map((_, i) => [rate(i)[2], temperature(i), stampNs(i)].join(","));
  fs.writeFileSync("hdf5.csv", ["gyro_z [rad/s],temp [degC],time [ns]", ...columns, ""].join("\n"));
}

// Messages of ROS.
const VECTOR3 = "float64 x\nfloat64 y\nfloat64 z";
const SEPARATOR = "\n" + "=".repeat(80) + "\nMSG: ";
const HEADERS = {
  1: "uint32 seq\ntime stamp\nstring frame_id",
  2: `builtin_interfaces/Time stamp\nstring frame_id${SEPARATOR}builtin_interfaces/Time\nint32 sec\nuint32 nanosec`,
};
const ownFields = {
  Imu: `std_msgs/Header header
geometry_msgs/Quaternion orientation
float64[9] orientation_covariance
geometry_msgs/Vector3 angular_velocity
float64[9] angular_velocity_covariance
geometry_msgs/Vector3 linear_acceleration
float64[9] linear_acceleration_covariance`,
  Temperature: "std_msgs/Header header\nfloat64 temperature\nfloat64 variance",
  Empty: "",
  Broken: "nowhere_msgs/Missing picture", // a type that is not there
};
function definition(type, ros) {
  if (type === "Empty" || type === "Broken") return ownFields[type];
  const parts = [ownFields[type], `std_msgs/Header\n${HEADERS[ros]}`];
  if (type === "Imu")
    parts.push(`geometry_msgs/Quaternion\n${VECTOR3}\nfloat64 w`, `geometry_msgs/Vector3\n${VECTOR3}`);
  return parts.join(SEPARATOR);
}

// stamped: false leaves the stamps 0, as some drivers do.
function message({ type, i }, ros, stamped) {
  const stamp = stamped ? stampNs(i) : 0n;
  const [sec, ns] = [Number(stamp / 1_000_000_000n), Number(stamp % 1_000_000_000n)];
  const header = { seq: i, stamp: ros === 1 ? { sec, nsec: ns } : { sec, nanosec: ns }, frame_id: "gyro" };
  if (type === "Temperature") return { header, temperature: temperature(i), variance: 0 };
  const [x, y, z] = rate(i);
  const none = Array(9).fill(0);
  return {
    header,
    orientation: { x: 0, y: 0, z: 0, w: 1 },
    orientation_covariance: none,
    angular_velocity: { x, y, z },
    angular_velocity_covariance: none,
    linear_acceleration: { x: 0, y: 0, z: 9.8 },
    linear_acceleration_covariance: none,
  };
}

function writersOf(ros) {
  const { parse } = required("@foxglove/rosmsg");
  const { MessageWriter } = required(`@foxglove/${ros === 1 ? "rosmsg" : "rosmsg2"}-serialization`);
  const writer = (type) => new MessageWriter(parse(definition(type, ros), { ros2: ros === 2 }));
  return { Imu: writer("Imu"), Temperature: writer("Temperature") };
}

class FileOf {
  constructor(file) {
    this.descriptor = fs.openSync(file, "w");
    this.bytes = 0n;
  }
  async write(bytes) {
    fs.writeSync(this.descriptor, bytes);
    this.bytes += BigInt(bytes.length);
  }
  position() {
    return this.bytes;
  }
}

// compress: of a chunk; undefined: none. topics: types by name; the messages of /imu/raw are those of /imu/data.
const TOPICS = { "/alive": "Empty", "/camera": "Broken", "/imu/data": "Imu", "/temp": "Temperature" };
async function writeMcap(file, { ros, compression, compress, topics = TOPICS, stamped = true }) {
  const { McapWriter } = required("@mcap/core");
  const compressChunk = compress && ((bytes) => ({ compression, compressedData: compress(bytes) }));
  const writer = new McapWriter({ writable: new FileOf(file), compressChunk, chunkSize: 8192 });
  await writer.start({ profile: `ros${ros}`, library: "" });
  const channels = {};
  for (const [topic, type] of Object.entries(topics)) {
    const name = ros === 1 ? `sensor_msgs/${type}` : `sensor_msgs/msg/${type}`;
    const data = new TextEncoder().encode(definition(type, ros));
    const schemaId = await writer.registerSchema({ name, encoding: `ros${ros}msg`, data });
    const messageEncoding = ros === 1 ? "ros1" : "cdr";
    channels[topic] = await writer.registerChannel({ topic, schemaId, messageEncoding, metadata: new Map() });
  }
  const writers = writersOf(ros);
  for (const each of messages()) {
    const logTime = loggedNs(each);
    const data = writers[each.type].writeMessage(message(each, ros, stamped));
    for (const topic of Object.keys(topics).filter((name) => topics[name] === each.type)) {
      const channelId = channels[topic];
      await writer.addMessage({ channelId, sequence: each.i, logTime, publishTime: logTime, data });
    }
  }
  await writer.end();
}

// A bag of format 2.0, in one chunk.
const u32 = (value) => {
  const bytes = Buffer.alloc(4);
  bytes.writeUInt32LE(value);
  return bytes;
};
const bagTime = (ns) => Buffer.concat([u32(Number(ns / 1_000_000_000n)), u32(Number(ns % 1_000_000_000n))]);
const u64 = (value) => {
  const bytes = Buffer.alloc(8);
  bytes.writeBigUInt64LE(BigInt(value));
  return bytes;
};
function bagFields(fields) {
  const parts = Object.entries(fields).map(([name, value]) =>
    Buffer.concat([Buffer.from(`${name}=`), Buffer.from(value)]),
  );
  return Buffer.concat(parts.flatMap((part) => [u32(part.length), part]));
}
function bagRecord(op, fields, data) {
  const header = bagFields({ op: Buffer.from([op]), ...fields });
  return Buffer.concat([u32(header.length), header, u32(data.length), data]);
}

function writeBag(file, stamped, compression = "none", compress = (bytes) => bytes) {
  const connections = Object.entries(TOPICS).map(([topic, type], id) => {
    const text = definition(type, 1);
    const md5sum = "0".repeat(32);
    const data = bagFields({ topic, type: `sensor_msgs/${type}`, md5sum, message_definition: text });
    return { topic, id, record: bagRecord(7, { conn: u32(id), topic }, data), times: [] };
  });
  const writers = writersOf(1);
  let chunk = Buffer.concat(connections.map(({ record }) => record));
  for (const each of messages()) {
    const connection = connections.find(({ topic }) => topic === each.topic);
    const time = bagTime(loggedNs(each));
    connection.times.push(Buffer.concat([time, u32(chunk.length)]));
    const data = Buffer.from(writers[each.type].writeMessage(message(each, 1, stamped)));
    chunk = Buffer.concat([chunk, bagRecord(2, { conn: u32(connection.id), time }, data)]);
  }
  const start = Buffer.from("#ROSBAG V2.0\n");
  const ahead = start.length + 4096;
  const body = [bagRecord(5, { compression, size: u32(chunk.length) }, compress(chunk))];
  for (const { id, times } of connections) {
    body.push(bagRecord(4, { ver: u32(1), conn: u32(id), count: u32(times.length) }, Buffer.concat(times)));
  }
  const indexed = Buffer.concat(body);
  const counts = connections.flatMap(({ id, times }) => [u32(id), u32(times.length)]);
  const span = { start_time: bagTime(stampNs(0)), end_time: bagTime(stampNs(SAMPLES)) };
  const info = { ver: u32(1), chunk_pos: u64(ahead), ...span, count: u32(connections.length) };
  const tail = [...connections.map(({ record }) => record), bagRecord(6, info, Buffer.concat(counts))];
  const fields = { index_pos: u64(ahead + indexed.length), conn_count: u32(connections.length), chunk_count: u32(1) };
  const unpadded = bagRecord(3, fields, Buffer.alloc(0)).length;
  const header = bagRecord(3, fields, Buffer.alloc(4096 - unpadded, " "));
  fs.writeFileSync(file, Buffer.concat([start, header, indexed, ...tail]));
}

// own: messages of types that only the bag's own definitions describe, as bags have them since Iron.
async function writeDb3(file, stamped, own = false) {
  const SQL = await required("sql.js")();
  const database = new SQL.Database();
  database.run(`CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
    serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);
    CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
    data BLOB NOT NULL);
    INSERT INTO topics VALUES (1, '/imu/data', 'sensor_msgs/msg/Imu', 'cdr', ''),
    (2, '/temp', 'sensor_msgs/msg/Temperature', 'cdr', ''), (3, '/camera', 'sensor_msgs/msg/Broken', 'cdr', '');`);
  if (own) {
    database.run(`UPDATE topics SET type = replace(type, 'sensor_msgs', 'own_msgs');
      CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL, encoding TEXT NOT NULL,
      encoded_message_definition TEXT NOT NULL, type_description_hash TEXT NOT NULL);`);
    for (const type of ["Imu", "Temperature", "Broken"]) {
      const values = [`own_msgs/msg/${type}`, "ros2msg", definition(type, 2), ""];
      database.run("INSERT INTO message_definitions VALUES (NULL, ?, ?, ?, ?)", values);
    }
  }
  const writers = writersOf(2);
  const insert = database.prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)");
  for (const each of messages()) {
    const data = writers[each.type].writeMessage(message(each, 2, stamped));
    insert.run([each.type === "Imu" ? 1 : 2, String(loggedNs(each)), data]);
  }
  fs.writeFileSync(file, database.export());
}

// A ULog of version 1: flags, a format, a subscription, data.
function ulogMessage(type, ...parts) {
  const body = Buffer.concat(parts);
  const head = Buffer.alloc(3);
  head.writeUInt16LE(body.length);
  head.write(type, 2);
  return Buffer.concat([head, body]);
}
const float = (value) => {
  const bytes = Buffer.alloc(4);
  bytes.writeFloatLE(value);
  return bytes;
};
function writeUlog(file) {
  const format = "sensor_gyro:uint64_t timestamp;uint64_t timestamp_sample;float x;float y;float z;float temperature;";
  const parts = [
    Buffer.from([0x55, 0x4c, 0x6f, 0x67, 0x01, 0x12, 0x35, 0x01]),
    u64(0),
    ulogMessage("B", Buffer.alloc(40)),
    ulogMessage("F", Buffer.from(format)),
    ulogMessage("A", Buffer.from([0, 7, 0]), Buffer.from("sensor_gyro")),
  ];
  for (let i = 0; i < SAMPLES; ++i) {
    const sampled = bootUs(i);
    const values = [...rate(i), temperature(i)].map(float);
    parts.push(ulogMessage("D", Buffer.from([7, 0]), u64(sampled + 250n), u64(sampled), ...values));
  }
  fs.writeFileSync(file, Buffer.concat(parts));
}

async function writeHdf5(file) {
  const { default: h5wasm } = await imported("h5wasm/dist/node/hdf5_hl.js");
  await h5wasm.ready;
  const output = new h5wasm.File(file, "w");
  const run = output.create_group("run");
  const column = (name, unit, data) => {
    run.create_dataset({ name, data, chunks: [100], compression: 4 }).create_attribute("units", unit);
  };
  const of = (value) => Array.from({ length: SAMPLES }, (_, i) => value(i));
  column("time", "ns", BigInt64Array.from(of(stampNs)));
  column("temp", "degC", Float64Array.from(of(temperature)));
  column("gyro_z", "rad/s", Float64Array.from(of((i) => rate(i)[2])));
  run.create_dataset({ name: "gains", data: Float64Array.from([1, 2, 3]) });
  const matrix = Float64Array.from([0, 1, 2].flatMap((axis) => of((i) => rate(i)[axis])));
  const gyro = output.create_dataset({ name: "gyro", data: matrix, shape: [3, SAMPLES] }); // as MATLAB has 400 x 3
  gyro.create_attribute("unit", "rad/s");
  output.close();
}

async function writeParquet(filename) {
  const { parquetWriteFile } = await imported("hyparquet-writer/src/node.js");
  const of = (value) => Array.from({ length: SAMPLES }, (_, i) => value(i));
  const time = { type: "TIMESTAMP", isAdjustedToUTC: true, unit: "NANOS" };
  const volt = { converted_type: "DECIMAL", precision: 12, scale: 2 };
  const schema = [
    { name: "root", num_children: 6 },
    { name: "stamp", type: "INT64", repetition_type: "REQUIRED", logical_type: time },
    { name: "temp [degC]", type: "DOUBLE", repetition_type: "OPTIONAL" },
    { name: "gyro_z [rad/s]", type: "DOUBLE", repetition_type: "REQUIRED" },
    { name: "n", type: "INT32", repetition_type: "REQUIRED" },
    { name: "volt", type: "FIXED_LEN_BYTE_ARRAY", type_length: 8, repetition_type: "REQUIRED", ...volt },
    { name: "note", type: "BYTE_ARRAY", repetition_type: "REQUIRED", converted_type: "UTF8" },
  ];
  const columnData = [
    { name: "stamp", data: of(stampNs) },
    { name: "temp [degC]", data: of((i) => (i % 100 ? temperature(i) : null)) },
    { name: "gyro_z [rad/s]", data: of((i) => rate(i)[2]) },
    { name: "n", data: of((i) => i) },
    { name: "volt", data: of((i) => i * -0.01) },
    { name: "note", data: of(() => "at rest") },
  ];
  await parquetWriteFile({ filename, columnData, schema, rowGroupSize: 150 });
}

writeExpected();
const lz4 = required("@foxglove/wasm-lz4");
const zstd = required("@foxglove/wasm-zstd");
await Promise.all([lz4.isLoaded, zstd.isLoaded]);
await writeMcap("run.mcap", { ros: 2 });
await writeMcap("ros1.mcap", { ros: 1, compression: "zstd", compress: (bytes) => zstd.compress(bytes, 3) });
await writeMcap("two.mcap", { ros: 2, topics: { ...TOPICS, "/imu/raw": "Imu" } });
await writeMcap("cold.mcap", { ros: 2, topics: { "/imu/data": "Imu" } });
await writeMcap("logged.mcap", { ros: 2, stamped: false });
writeBag("run.bag", true);
writeBag("logged.bag", false);
writeBag("packed.bag", true, "bz2", (input) => execFileSync("bzip2", ["-c"], { input }));
await writeDb3("run.db3", true);
await writeDb3("logged.db3", false, true);
writeUlog("run.ulg");
await writeHdf5("run.h5");
await writeParquet("run.parquet");
