// A stand-in for Flamenco Manager 3: compiles a job type with the settings' defaults, and does its tasks in an order that their dependencies allow.
//   node flamenco.js <job type> <fumage-cli>
"use strict";
const assert = require("assert");
const { spawnSync } = require("child_process");
const fs = require("fs");
const vm = require("vm");

const [jobTypeFile, program] = process.argv.slice(2);

class Task {
    constructor(name, type) {
        assert(["blender", "ffmpeg", "file-management", "misc"].includes(type), type);
        Object.assign(this, { name, type, commands: [], dependencies: [] });
    }
    addCommand(command) { this.commands.push(command); }
    addDependency(task) { this.dependencies.push(task); }
}

// As the manager divides a range: "0-3", and "8" where one is left.
function frameChunker(range, size) {
    const [first, last] = range.split("-").map(Number);
    const chunks = [];
    for (let at = first; at <= last; at += size) {
        const end = Math.min(at + size - 1, last);
        chunks.push(at === end ? `${at}` : `${at}-${end}`);
    }
    return chunks;
}

const manager = {
    author: { Task: (name, type) => new Task(name, type), Command: (name, parameters) => ({ name, parameters }) },
    frameChunker,
};
vm.createContext(manager);
vm.runInContext(fs.readFileSync(jobTypeFile, "utf8") + "\nthis.jobType = JOB_TYPE; this.compile = compileJob;", manager);

const settings = {};
for (const setting of manager.jobType.settings) {
    assert(["string", "int32", "float", "bool"].includes(setting.type), setting.type);
    settings[setting.key] = setting.default;
}
settings.program = program;
const tasks = [];
manager.compile({ settings, addTask: (task) => tasks.push(task) });

const done = new Set();
for (const task of tasks) {
    assert(task.dependencies.every((each) => done.has(each)), "a task comes before what it depends on");
    for (const command of task.commands) {
        assert.strictEqual(command.name, "exec");
        const outcome = spawnSync(command.parameters.exe, [...command.parameters.args]);
        assert.strictEqual(outcome.status, 0, `${task.name}: ${outcome.stderr}`);
    }
    done.add(task);
}
const join = tasks[tasks.length - 1];
assert.strictEqual(join.dependencies.length, tasks.length - 1);
console.log(`${tasks.length} tasks: ${tasks.map((task) => task.name).join(", ")}`);
