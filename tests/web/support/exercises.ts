import { type ExerciseTask, type Failure, grade, taskNamed } from 'halfedge/exercise/judge';

/** What a program is told first. */
export function failureOf(task: string | ExerciseTask, code: string, seed = 5): Failure {
  const { failure } = grade(typeof task === 'string' ? taskNamed(task) : task, code, seed);
  if (!failure) throw new Error(`The program was taken for right:\n${code}`);
  return failure;
}
