"""Mean and scatter of the beds, as results.txt: name value low high"""
import statistics

with open("ensemble.dat") as file:
    rows = {int(r[0]): [float(x) for x in r[1:]] for r in map(str.split, file)}
with open("ensemble-alone.dat") as file:
    alone = float(file.read().split()[2])
k = [row[1] / row[2] for row in rows.values()]
with open("results.txt", "w") as out:
    print(f"beds {len(k)} 4 -", file=out)
    print(f"k_over_Carman-Kozeny_mean {statistics.mean(k):.4f} 0.85 1.15", file=out)
    print(f"k_over_Carman-Kozeny_standard_deviation {statistics.stdev(k):.4f} 0.01 0.15", file=out)
    print(f"seed_1_in_a_partition_over_alone {rows[1][1] / alone:.6f} 0.999999 1.000001", file=out)
print(open("results.txt").read(), end="")
