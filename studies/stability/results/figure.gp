set terminal svg size 940,470 font "Helvetica,13" background rgb "white"
set output "figure.svg"
set datafile separator ","
set multiplot layout 1,2
set border 3
set tics nomirror
set bmargin 6
set key at graph 0.5, graph -0.26 center top maxcols 2 samplen 2
set bmargin 10
set key at graph 0.5, graph -0.27 maxcols 2 maxrows 5 width -3
set logscale xy
set format "10^{%T}"
set xlabel "jitter / cell"
set ylabel "|change of k| / k"
set xrange [3e-16:3e-6]
set xtics 1e-15, 1e3
set yrange [3e-17:10]
of(name, column) = strcol(1) eq name ? column : 1/0
plot 1e-7 + 20 * x with lines dt 2 lc rgb "#888888" title "bound", \
     "jitter.csv" skip 1 using 2:(of("simple cubic", $3)) with points pt 7 lc rgb "#1f5fa8" title "simple cubic", \
     "jitter.csv" skip 1 using 2:(of("BCC", $3)) with points pt 5 ps 0.8 lc rgb "#1f5fa8" title "BCC", \
     "jitter.csv" skip 1 using 2:(of("FCC", $3)) with points pt 9 lc rgb "#1f5fa8" title "FCC", \
     "jitter.csv" skip 1 using 2:(of("nine spheres", $3)) with points pt 13 lc rgb "#1f5fa8" title "nine spheres", \
     "jitter.csv" skip 1 using 2:(of("simple cubic", $4)) with points pt 6 lc rgb "#c0504d" title "YADE, simple cubic", \
     "jitter.csv" skip 1 using 2:(of("nine spheres", $4)) with points pt 12 lc rgb "#c0504d" title "YADE, nine spheres"
set xlabel "size ratio"
set ylabel "share"
set format x "%g"
set xrange [0.8:25]
set xtics (1, 5, 20)
plot "passivity.csv" skip 1 using 1:2 with linespoints pt 7 lc rgb "#1f5fa8" title "asymmetry", \
     "passivity.csv" skip 1 using 1:3 with linespoints pt 5 ps 0.8 lc rgb "#1f5fa8" title "negative eigenvalue", \
     "passivity.csv" skip 1 using 1:4 with linespoints pt 6 lc rgb "#c0504d" title "YADE, asymmetry", \
     "passivity.csv" skip 1 using 1:5 with linespoints pt 4 ps 0.8 lc rgb "#c0504d" title "YADE, negative eigenvalue", \
     "passivity.csv" skip 1 using 1:6 with linespoints pt 9 lc rgb "#4f8f4f" title "energy balance"
