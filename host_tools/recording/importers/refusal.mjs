/** What is wrong with a file and what to do, as one line without the file's name. */
export class Refusal extends Error {}
